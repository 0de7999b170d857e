package nephele.engine.scene;

import nephele.engine.math.Vec3;

/** Where what one view sees at a place is in another view's picture, both homogeneous; reused. */
public final class Reprojection {
    /** Three rows of factors on x, y, w and 1. */
    private final double[] rows = new double[12];

    public void between(View from, View to) {
        row(0, from, to, to.right(), 1 / to.projection().tanHalfWidth());
        row(4, from, to, to.up(), 1 / to.projection().tanHalfHeight());
        row(8, from, to, to.back(), -1);
    }

    private void row(int at, View from, View to, Vec3 axis, double scale) {
        rows[at] = scale * from.projection().tanHalfWidth() * dot(axis, from.right());
        rows[at + 1] = scale * from.projection().tanHalfHeight() * dot(axis, from.up());
        rows[at + 2] = -scale * dot(axis, from.back());
        rows[at + 3] = scale
                * (axis.x() * (from.eye().x() - to.eye().x())
                        + axis.y() * (from.eye().y() - to.eye().y())
                        + axis.z() * (from.eye().z() - to.eye().z()));
    }

    private static double dot(Vec3 a, Vec3 b) {
        return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
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
