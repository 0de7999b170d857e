package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class WeldTest {
    private final List<Double> positions = new ArrayList<>();
    private final List<Integer> vertices = new ArrayList<>();

    private TriangleSoup soup() {
        return new TriangleSoup(
                positions.stream().mapToDouble(d -> d).toArray(),
                vertices.stream().mapToInt(i -> i).toArray());
    }

    private int vertex(double x, double y, double z) {
        positions.addAll(List.of(x, y, z));
        return positions.size() / 3 - 1;
    }

    private void quad(double[] corner, double[] u, double[] v, double noise, SplittableRandom random) {
        int[] corners = new int[4];
        for (int i = 0; i < 4; i++) {
            double s = i == 1 || i == 2 ? 1 : 0;
            double t = i >= 2 ? 1 : 0;
            double[] p = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                p[axis] = corner[axis] + s * u[axis] + t * v[axis] + noise * random.nextDouble(-1, 1);
            }
            corners[i] = vertex(p[0], p[1], p[2]);
        }
        vertices.addAll(List.of(corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]));
    }

    /** A closed box whose faces are cut into different grids, so that almost every edge has T-junctions. */
    private void roomOfMismatchedTiles(double noise) {
        var random = new SplittableRandom(20);
        double[][] axes = {{8, 0, 0}, {0, 3, 0}, {0, 0, 6}};
        for (int axis = 0; axis < 3; axis++) {
            for (int side = 0; side < 2; side++) {
                double[] u = axes[(axis + 1 + side) % 3];
                double[] v = axes[(axis + 2 - side) % 3];
                int columns = 1 + axis + 2 * side;
                int rows = 2 + side;
                for (int i = 0; i < columns * rows; i++) {
                    double[] corner = new double[3];
                    for (int k = 0; k < 3; k++) {
                        double at = i % columns / (double) columns * u[k] + i / columns / (double) rows * v[k];
                        corner[k] = at + side * axes[axis][k];
                    }
                    quad(corner, times(u, 1.0 / columns), times(v, 1.0 / rows), noise, random);
                }
            }
        }
    }

    private static double[] times(double[] v, double s) {
        return new double[] {v[0] * s, v[1] * s, v[2] * s};
    }

    /** After welding each edge has exactly one partner with the same two vertices, in the other direction. */
    @Test
    void aRoomOfMismatchedTilesIsClosedBitForBit() {
        roomOfMismatchedTiles(2e-5);
        assertTrue(unpartnered(soup()) > 0, "the room must have cracks to close");
        TriangleSoup closed = Weld.closed(soup());
        assertEquals(0, unpartnered(closed));
        assertEquals(volume(soup()), volume(closed), 0.01);
        assertEquals(8 * 3 * 6, Math.abs(volume(closed)), 0.05);
    }

    private static int unpartnered(TriangleSoup soup) {
        Map<List<Integer>, Integer> balance = new HashMap<>();
        for (int at = 0; at < soup.vertices().length; at += 3) {
            for (int k = 0; k < 3; k++) {
                int a = soup.vertices()[at + k];
                int b = soup.vertices()[at + (k + 1) % 3];
                balance.merge(List.of(Math.min(a, b), Math.max(a, b)), a < b ? 1 : -1, Integer::sum);
            }
        }
        return (int) balance.values().stream().filter(n -> n != 0).count();
    }

    private static double volume(TriangleSoup soup) {
        double six = 0;
        for (int at = 0; at < soup.vertices().length; at += 3) {
            six += Directions.dot(point(soup, at), Directions.cross(point(soup, at + 1), point(soup, at + 2)));
        }
        return six / 6;
    }

    private static Vec3 point(TriangleSoup soup, int at) {
        int v = 3 * soup.vertices()[at];
        return new Vec3(soup.positions()[v], soup.positions()[v + 1], soup.positions()[v + 2]);
    }

    /** Slivers and duplicates are dropped and counted, and every remaining triangle has a normal. */
    @Test
    void sliversAndDuplicatesAreDroppedWithCount() {
        int a = vertex(0, 0, 0);
        int b = vertex(10, 0, 0);
        int c = vertex(0, 10, 0);
        int onEdge = vertex(5, 1e-13, 0);
        int nan = vertex(Double.NaN, 0, 0);
        vertices.addAll(List.of(a, b, c, b, c, a, a, c, b, a, onEdge, b, a, a, c, a, b, nan));
        positions.set(3 * nan, 0.0);
        positions.set(3 * nan + 1, 1e-14);
        TriangleSoup.Cleaned cleaned = soup().cleaned();
        assertEquals(3, cleaned.slivers());
        assertEquals(1, cleaned.duplicates());
        assertEquals(2, cleaned.soup().triangleCount());
        var random = new SplittableRandom(19);
        for (int i = 0; i < 5000; i++) {
            double size = Math.pow(10, random.nextDouble(-12, 2));
            vertices.addAll(List.of(
                    vertex(size * random.nextDouble(), random.nextDouble(), 0),
                    a,
                    vertex(0, random.nextDouble(), size)));
        }
        TriangleSoup kept = soup().cleaned().soup();
        assertTrue(kept.triangleCount() > 100 && kept.triangleCount() < 5000, kept.triangleCount() + " kept");
        for (int at = 0; at < kept.vertices().length; at += 3) {
            Vec3 p = point(kept, at);
            Vec3 q = point(kept, at + 1);
            Vec3 r = point(kept, at + 2);
            double[] corners = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), r.x(), r.y(), r.z()};
            assertNotNull(TriangleRay.normal(corners, 0));
        }
    }

    @Test
    void notANumberIsNoTriangle() {
        vertices.addAll(List.of(vertex(0, 0, 0), vertex(1, 0, 0), vertex(0, Double.NaN, 0)));
        assertEquals(1, soup().cleaned().slivers());
    }
}
