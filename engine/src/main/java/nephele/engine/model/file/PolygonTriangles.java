package nephele.engine.model.file;

import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;

/**
 * Triangulates a polygon, concave or not, by ear clipping (Meisters 1975) in the plane of its Newell normal. A polygon
 * that intersects itself is cut on a best-effort basis.
 */
final class PolygonTriangles {
    private final double[] x;
    private final double[] y;
    private final int[] next;
    private final int[] previous;

    /** Number of corner tests so far; bounds the cost of hostile files. */
    private long tests;

    private PolygonTriangles(int corners) {
        x = new double[corners];
        y = new double[corners];
        next = new int[corners];
        previous = new int[corners];
        for (int i = 0; i < corners; i++) {
            next[i] = (i + 1) % corners;
            previous[i] = (i + corners - 1) % corners;
        }
    }

    /**
     * Triangulates a polygon and returns the number of corner tests; more than {@code mostTests} if it gave up.
     *
     * @param corners each begins with the index of its position
     * @param triangles receives three indices of corners for each triangle
     */
    static long cut(FloatList positions, int[][] corners, long mostTests, ItemList triangles) {
        var polygon = new PolygonTriangles(corners.length);
        polygon.flatten(positions, corners);
        polygon.clip(corners.length, mostTests, triangles);
        return polygon.tests;
    }

    /** Projects along the Newell normal of the polygon; the first corner is the origin, for precision. */
    private void flatten(FloatList positions, int[][] corners) {
        Vector3d[] places = new Vector3d[x.length];
        for (int i = 0; i < places.length; i++) {
            int at = 3 * corners[i][0];
            places[i] = new Vector3d(positions.at(at), positions.at(at + 1), positions.at(at + 2));
            if (i > 0) {
                places[i].sub(places[0]);
            }
        }
        places[0].zero();
        Vector3d normal = new Vector3d();
        for (int i = 0; i < places.length; i++) {
            normal.add(places[i].cross(places[next[i]], new Vector3d()));
        }
        Vector3d right = across(normal);
        Vector3d up = normal.cross(right, new Vector3d()).normalize();
        for (int i = 0; i < places.length; i++) {
            x[i] = places[i].dot(right);
            y[i] = normal.lengthSquared() == 0 ? 0 : places[i].dot(up);
        }
    }

    private static Vector3d across(Vector3d normal) {
        boolean alongX = Math.abs(normal.x) > 0.9 * normal.length();
        Vector3d other = alongX ? new Vector3d(0, 1, 0) : new Vector3d(1, 0, 0);
        Vector3d right = other.cross(normal);
        return right.lengthSquared() == 0 ? right.set(1, 0, 0) : right.normalize();
    }

    private void clip(int corners, long mostTests, ItemList triangles) {
        int left = corners;
        int at = 0;
        int failed = 0;
        while (left > 3 && tests <= mostTests) {
            if (failed >= left || isEar(at)) {
                add(at, triangles);
                next[previous[at]] = next[at];
                previous[next[at]] = previous[at];
                left--;
                failed = 0;
                at = previous[at];
            } else {
                failed++;
                at = next[at];
            }
        }
        add(at, triangles);
    }

    private void add(int corner, ItemList triangles) {
        triangles.accept(previous[corner]);
        triangles.accept(corner);
        triangles.accept(next[corner]);
    }

    /** Returns true if the corner is convex and its triangle contains no other corner. */
    private boolean isEar(int corner) {
        int before = previous[corner];
        int after = next[corner];
        if (turn(before, corner, after) <= 0) {
            return false;
        }
        for (int i = next[after]; i != before; i = next[i]) {
            tests++;
            if (blocks(i, before, corner, after)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Returns true if a corner is in the triangle; corners at one of the triangle's, as at bridges to holes, do not
     * count.
     */
    private boolean blocks(int i, int a, int b, int c) {
        boolean inside = turn(a, b, i) >= 0 && turn(b, c, i) >= 0 && turn(c, a, i) >= 0;
        return inside && !same(i, a) && !same(i, b) && !same(i, c);
    }

    private boolean same(int i, int j) {
        return x[i] == x[j] && y[i] == y[j];
    }

    /** Returns twice the signed area of the triangle, positive if counter-clockwise. */
    private double turn(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
}
