package nephele.engine.collision.rigid.body;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Moments of inertia equal sums over thin discs, or those of textbooks. */
class BodyTableTest {
    private static final int DISCS = 20_000;

    private static void assertFrameStates(Body body, double x, double y, double z) {
        var table = new BodyTable(List.of(body));
        assertEquals(1 / body.massKilograms(), table.inverseMass(0), 1e-15);
        double[] expected = {x, y, z};
        for (int axis = 0; axis < 3; axis++) {
            assertEquals(1, expected[axis] * table.inverseInertia(0, axis), 1e-6, "axis " + axis);
        }
    }

    @ParameterizedTest
    @CsvSource({"0.25, 1.8", "0.5, 1.2", "0.3, 0.6", "0.01, 2"})
    void aCapsuleIsTheSumOfItsDiscs(double radius, double height) {
        double straight = height / 2 - radius;
        double thickness = height / DISCS;
        double volume = 0;
        double along = 0;
        double across = 0;
        for (int i = 0; i < DISCS; i++) {
            double y = (i + 0.5) * thickness - height / 2;
            double inCap = Math.max(0, Math.abs(y) - straight);
            double square = radius * radius - inCap * inCap;
            volume += square;
            along += square * square / 2;
            across += square * (square / 4 + y * y);
        }
        double mass = 7;
        Body capsule = new Body.Capsule("c", Vec3.ZERO, radius, height, mass, null, 0, 0);
        assertFrameStates(capsule, mass * across / volume, mass * along / volume, mass * across / volume);
    }

    @Test
    void aBoxAndABallAreThoseOfTheTextbook() {
        Body box = new Body.Box("b", Vec3.ZERO, new Vec3(2, 3, 5), 12, null, 0, 0);
        assertFrameStates(box, 9 + 25, 4 + 25, 4 + 9);
        assertFrameStates(new Body.Sphere("s", Vec3.ZERO, 0.5, 10, null, 0, 0), 1, 1, 1);
    }
}
