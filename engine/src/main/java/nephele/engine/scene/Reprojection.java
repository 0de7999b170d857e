package nephele.engine.scene;

import org.joml.Vector3d;

/** Maps homogeneous picture coordinates in one view to those in another; reused. */
public final class Reprojection {
    /** Three rows of factors on x, y, w and 1. */
    private final double[] rows = new double[12];

    private final Vector3d axis = new Vector3d();

    public void between(View from, View to) {
        row(0, from, to, to.direction(1 / to.projection().tanHalfWidth(), 0, 0, axis));
        row(4, from, to, to.direction(0, 1 / to.projection().tanHalfHeight(), 0, axis));
        row(8, from, to, to.direction(0, 0, -1, axis));
    }

    private void row(int at, View from, View to, Vector3d along) {
        rows[at] = from.projection().tanHalfWidth() * from.alongRight(along.x, along.y, along.z);
        rows[at + 1] = from.projection().tanHalfHeight() * from.alongUp(along.x, along.y, along.z);
        rows[at + 2] = -from.alongBack(along.x, along.y, along.z);
        rows[at + 3] = along.dot(from.eyeX() - to.eyeX(), from.eyeY() - to.eyeY(), from.eyeZ() - to.eyeZ());
    }

    /** Returns the factors on x, y, w and 1 in a row of the map: 0 for x, 1 for y, 2 for w. */
    public double factor(int row, int column) {
        return rows[4 * row + column];
    }

    public double x(double x, double y, double w) {
        return rows[0] * x + rows[1] * y + rows[2] * w + rows[3];
    }

    public double y(double x, double y, double w) {
        return rows[4] * x + rows[5] * y + rows[6] * w + rows[7];
    }

    public double w(double x, double y, double w) {
        return rows[8] * x + rows[9] * y + rows[10] * w + rows[11];
    }
}
