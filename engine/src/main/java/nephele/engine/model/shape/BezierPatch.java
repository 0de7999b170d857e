package nephele.engine.model.shape;

import org.joml.Vector3d;

/**
 * A bicubic Bézier patch over the unit square.
 *
 * @param points 16 control points in row-major order; u runs along a row, v from row to row
 */
record BezierPatch(Vector3d[] points) {
    static final int SIDE = 4;

    /** Returns the sum of all points, each multiplied by its column's and its row's weight. */
    Vector3d weighted(double[] columns, double[] rows) {
        return along(across(columns), rows);
    }

    /** Returns the weighted sum of each row's points; it is the same for all points of one u. */
    Vector3d[] across(double[] columns) {
        Vector3d[] across = new Vector3d[SIDE];
        for (int row = 0; row < SIDE; row++) {
            across[row] = symmetricSum(
                    points[SIDE * row],
                    points[SIDE * row + 1],
                    points[SIDE * row + 2],
                    points[SIDE * row + 3],
                    columns);
        }
        return across;
    }

    /** @param across the result of {@link #across} */
    static Vector3d along(Vector3d[] across, double[] rows) {
        return symmetricSum(across[0], across[1], across[2], across[3], rows);
    }

    /** Sums bitwise equally from both ends, so that patches join without a gap for either direction of their edges. */
    private static Vector3d symmetricSum(Vector3d a, Vector3d b, Vector3d c, Vector3d d, double[] weights) {
        Vector3d outer = new Vector3d(a).mul(weights[0]).add(new Vector3d(d).mul(weights[3]));
        Vector3d inner = new Vector3d(b).mul(weights[1]).add(new Vector3d(c).mul(weights[2]));
        return outer.add(inner);
    }
}
