package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.TriangleSoup;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import org.junit.jupiter.api.Test;

/**
 * The four-lines test of the student report is right if its lines cross every gap, and wrong beside a hole between
 * them.
 */
class FourLineCheckTest {
    private static final Vec3 RIGHT = new Vec3(0.6, 0, 0);
    private static final Vec3 UP = new Vec3(0, 1.05, 0);

    /** Returns a wall of unit squares, 4 × 4 m, two triangles each; one square may be missing. */
    private static TriangleSoup squares(int missing) {
        double[] positions = new double[75];
        for (int i = 0; i < 25; i++) {
            positions[3 * i] = i % 5;
            positions[3 * i + 1] = Math.floorDiv(i, 5);
        }
        List<Integer> vertices = new ArrayList<>();
        for (int square = 0; square < 16; square++) {
            int low = square / 4 * 5 + square % 4;
            if (square != missing) {
                vertices.addAll(List.of(low, low + 1, low + 6, low, low + 6, low + 5));
            }
        }
        return new TriangleSoup(
                positions, vertices.stream().mapToInt(Integer::intValue).toArray());
    }

    private static boolean fits(TriangleSoup soup, double x, double y) {
        for (int triangle = 0; triangle < soup.triangleCount(); triangle++) {
            double[] corners = new double[6];
            for (int i = 0; i < 3; i++) {
                corners[2 * i] = soup.positions()[3 * soup.vertices()[3 * triangle + i]];
                corners[2 * i + 1] = soup.positions()[3 * soup.vertices()[3 * triangle + i] + 1];
            }
            if (ConvexPolygon.of(corners).outside(x, y) <= 0) {
                return new FourLineCheck(soup).fits(triangle, new Vec3(x, y, 0), RIGHT, UP);
            }
        }
        throw new AssertionError("nothing is aimed at");
    }

    @Test
    void onAWholeWallTheyAreRight() {
        TriangleSoup whole = squares(-1);
        for (double x = 0.05; x < 4; x += 0.1) {
            for (double y = 0.025; y < 4; y += 0.1) {
                boolean inside = x > 0.6 && x < 3.4 && y > 1.05 && y < 2.95;
                assertEquals(inside, fits(whole, x, y), x + ", " + y);
            }
        }
    }

    @Test
    void aHoleBetweenTheLinesIsNotSeen() {
        TriangleSoup holed = squares(5);
        assertFalse(fits(holed, 2.5, 2.5));
        assertTrue(fits(holed, 2.55, 1.45), "no line passes through the square from (1, 1) to (2, 2)");
        PlacementSurfaces surfaces = PlacementSurfaces.of(List.of(), SurfacePolygon.of(holed, true));
        assertEquals(1, surfaces.regions());
        Gun gun = Walls.gun(PortalShape.RECTANGLE, 1.2, 2.1);
        var aim = new ShotRay(new Vec3(2.55, 1.45, 5), nephele.engine.math.Basis.WORLD);
        PlacementResult exact = new Placement(surfaces, gun).place("p", aim, List.of(), Obstacles.NONE);
        assertEquals(2.6, Walls.fits(exact).centre().x(), 1e-6);
    }
}
