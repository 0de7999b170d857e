package nephele.engine.math.heightfield;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HeightFieldSurfaceTest {
    private static HeightField bumps(double out, double cellX, double cellZ, int columns, int rows) {
        return HeightField.of(
                new Vec3(out, out / 50, -out),
                cellX,
                cellZ,
                columns,
                rows,
                (column, row) -> 3 * Math.sin(1.7 * column) * Math.cos(2.3 * row) - 2);
    }

    /** Ray and surface meet the same triangles, of square and oblong cells, near and far. */
    @ParameterizedTest
    @CsvSource({"0, 1, 1, 33, 33", "0, 0.25, 8, 2, 2", "1e4, 3, 0.1, 5, 40", "-1e5, 0.5, 2, 65, 3"})
    void raysDownMeetTheSurface(double out, double cellX, double cellZ, int columns, int rows) {
        HeightField field = bumps(out, cellX, cellZ, columns, rows);
        SplittableRandom random = new SplittableRandom(1);
        RayHit hit = new RayHit();
        for (int i = 0; i < 500; i++) {
            double x = out + cellX * (columns - 1) * random.nextDouble();
            double z = -out + cellZ * (rows - 1) * random.nextDouble();
            double from = out / 50 + 20;
            assertTrue(field.nearest(
                    new Ray(x, from, z, 0, -1, 0), 100, (ray, triangle, most) -> field.entry(ray, triangle), hit));
            assertEquals(from - hit.distance(), HeightFieldSurface.y(field, x, z), 1e-8);
        }
    }

    @Test
    void thereIsNoSurfaceBesideTheField() {
        HeightField field = bumps(0, 1, 2, 3, 3);
        assertTrue(Double.isNaN(HeightFieldSurface.y(field, -1e-9, 1)));
        assertTrue(Double.isNaN(HeightFieldSurface.y(field, 1, 4.001)));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "0.5, 4", "3, 0.2"})
    void theNormalOfAPlaneIsThatOfItsTriangles(double cellX, double cellZ) {
        HeightField field = HeightField.of(
                new Vec3(5, 6, 7), cellX, cellZ, 6, 9, (column, row) -> 0.5 * column * cellX - 0.25 * row * cellZ);
        for (double place : new double[] {0, 0.3, 1}) {
            Vec3 smooth = HeightFieldSurface.normal(field, 5 + place * 5 * cellX, 7 + place * 8 * cellZ);
            for (int triangle = 0; triangle < field.triangles(); triangle++) {
                Vec3 flat = field.normal(triangle);
                assertEquals(flat.x(), smooth.x(), 1e-5);
                assertEquals(flat.y(), smooth.y(), 1e-5);
                assertEquals(flat.z(), smooth.z(), 1e-5);
            }
        }
    }
}
