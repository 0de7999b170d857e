package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UprightPrismTest {
    private static List<Plane> planes(Vec3 centre, double apothem, double height, int sides) {
        List<Plane> planes = new ArrayList<>();
        planes.add(new Plane(0, 1, 0, centre.y() + height / 2));
        planes.add(new Plane(0, -1, 0, -(centre.y() - height / 2)));
        for (int i = 0; i < sides; i++) {
            double nx = StrictMath.cos(2 * Math.PI * i / sides);
            double nz = StrictMath.sin(2 * Math.PI * i / sides);
            planes.add(new Plane(nx, 0, nz, nx * centre.x() + nz * centre.z() + apothem));
        }
        return planes;
    }

    /** Equal to the last bit and in order, so that levels keep their images and replays. */
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 6, 7, 8, 12, 16, 31, 62})
    void itIsWhatItsPlanesEnclose(int sides) {
        for (Vec3 centre : List.of(Vec3.ZERO, new Vec3(-2.5, 1, 7), new Vec3(103.7, -3, -0.1))) {
            List<Plane> planes = planes(centre, 0.7, 2.4, sides);
            assertEquals(ConvexPolyhedron.fromPlanes(planes), UprightPrism.of(planes));
        }
    }

    /**
     * A weld tolerance relative to the height would merge all corners of a ring; the last case is at a level's far
     * limit.
     */
    @ParameterizedTest
    @CsvSource({"0.001, 10000, 62, 0", "0.0001, 10000000, 62, 0", "0.001, 0.001, 62, 10000000"})
    void aNeedleKeepsItsSides(double radius, double height, int sides, double x) {
        ConvexPolyhedron needle =
                UprightPrism.of(planes(new Vec3(x, 0, 0), radius * StrictMath.cos(Math.PI / sides), height, sides));
        assertEquals(sides + 2, needle.faces().size());
        assertEquals(2 * sides, needle.vertices().stream().distinct().count());
        for (Vec3 corner : needle.vertices()) {
            assertEquals(radius, Math.hypot(corner.x() - x, corner.z()), 1e-14 * x + 1e-12 * radius);
            assertEquals(height / 2, Math.abs(corner.y()));
        }
    }
}
