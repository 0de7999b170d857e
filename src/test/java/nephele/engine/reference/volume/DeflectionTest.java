package nephele.engine.reference.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Deflected directions have unit length and the asked angle, in all directions around the old one. */
class DeflectionTest {
    @Test
    void aDeflectionHasItsSeparationAndAnyAngleAround() {
        var random = new SplittableRandom(7);
        List<Vec3> axes = List.of(
                new Vec3(1, 0, 0),
                new Vec3(0, -1, 0),
                new Vec3(0, 0, 1),
                new Vec3(0, 0, -1),
                Directions.unit(1, -2, -3));
        for (Vec3 axis : axes) {
            for (double separation : new double[] {0, 1e-12, 0.5, 2, 3.9, 4}) {
                Vec3 sum = Vec3.ZERO;
                for (int n = 0; n < 4000; n++) {
                    Vec3 turned = Deflection.of(axis, separation, random);
                    assertEquals(1, turned.length(), 1e-14);
                    assertEquals(
                            separation,
                            Deflection.separation(axis, turned),
                            1e-14 + 1e-7 * Math.sqrt(separation) * 1e-3);
                    sum = sum.plus(turned);
                }
                Vec3 mean = sum.scaled(1.0 / 4000);
                double sine = Math.sqrt(separation * (1 - separation / 4));
                assertEquals(
                        0, mean.minus(axis.scaled(1 - separation / 2)).length(), 1e-9 + 5 * sine / Math.sqrt(4000));
            }
        }
    }
}
