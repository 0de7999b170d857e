package nephele.engine.math;

import org.joml.Matrix4dc;

/**
 * The half spaces that a view can see, relative to its eye. Tests are conservative: a box of which clipping keeps a
 * part is never outside, even after the graphics hardware has rounded to float.
 */
public final class Frustum {
    /** The result of {@link #classify} for a box that is outside. */
    public static final int OUTSIDE = -1;

    /** Slack relative to the magnitudes involved: four times the float rounding of 2⁻²⁴. */
    private static final double RELATIVE_SLACK = 0x1p-22;

    /** Length, relative to the matrix, below which a normal belongs to an infinite far plane with rounding errors. */
    private static final double NULL_NORMAL = 1e-12;

    private static final int STRIDE = 5;

    /** a, b, c, d and absolute slack of each half space a·x + b·y + c·z + d ≥ 0, with x relative to the eye. */
    private final double[] planes;

    private int count;
    private double eyeX;
    private double eyeY;
    private double eyeZ;

    private Frustum(double[] planes, int count, double eyeX, double eyeY, double eyeZ) {
        this.planes = planes;
        this.count = count;
        this.eyeX = eyeX;
        this.eyeY = eyeY;
        this.eyeZ = eyeZ;
    }

    /**
     * Returns the planes of a projection (Gribb and Hartmann 2001, section 2), at the scale of the matrix. A far plane
     * at infinity has no normal and is dropped.
     *
     * @param clipFromRelative projection · rotation, for positions relative to {@code eye}
     */
    public static Frustum of(Matrix4dc clipFromRelative, Vec3 eye) {
        Frustum frustum = reusable(6);
        frustum.restart(eye.x(), eye.y(), eye.z());
        frustum.keepAll(clipFromRelative);
        return frustum;
    }

    /** Adds the planes of a projection matrix as in {@link #of} to a {@link #reusable} frustum. */
    public void keepAll(Matrix4dc clipFromRelative) {
        Matrix4dc m = clipFromRelative;
        double scale = Math.abs(m.getRowColumn(3, 0)) + Math.abs(m.getRowColumn(3, 1));
        scale += Math.abs(m.getRowColumn(3, 2)) + Math.abs(m.getRowColumn(3, 3));
        for (int row = 0; row < 3; row++) {
            for (int sign = 1; sign >= -1; sign -= 2) {
                double a = m.getRowColumn(3, 0) + sign * m.getRowColumn(row, 0);
                double b = m.getRowColumn(3, 1) + sign * m.getRowColumn(row, 1);
                double c = m.getRowColumn(3, 2) + sign * m.getRowColumn(row, 2);
                if (Math.abs(a) + Math.abs(b) + Math.abs(c) > NULL_NORMAL * scale) {
                    keep(a, b, c, m.getRowColumn(3, 3) + sign * m.getRowColumn(row, 3));
                }
            }
        }
    }

    /** Returns a frustum without planes. */
    public static Frustum everything() {
        return new Frustum(new double[0], 0, 0, 0, 0);
    }

    /** Returns an empty frustum with room for a number of half spaces, to be refilled every frame. */
    public static Frustum reusable(int mostPlanes) {
        return new Frustum(new double[mostPlanes * STRIDE], 0, 0, 0, 0);
    }

    /** Removes all half spaces of a {@link #reusable} frustum and sets its eye. */
    public void restart(double newEyeX, double newEyeY, double newEyeZ) {
        count = 0;
        eyeX = newEyeX;
        eyeY = newEyeY;
        eyeZ = newEyeZ;
    }

    /** Adds the half space a·x + b·y + c·z + d ≥ 0, x relative to the eye, to a {@link #reusable} frustum. */
    public void keep(double a, double b, double c, double d) {
        put(planes, count++ * STRIDE, a, b, c, d, Math.max(Math.abs(eyeX), Math.max(Math.abs(eyeY), Math.abs(eyeZ))));
    }

    /** Adds the half space in front of {@code plane}, in world coordinates, to a {@link #reusable} frustum. */
    public void keepInFrontOf(Plane plane) {
        keep(plane.nx(), plane.ny(), plane.nz(), plane.signedDistance(eyeX, eyeY, eyeZ));
    }

    private static void put(double[] planes, int at, double a, double b, double c, double d, double farthest) {
        planes[at] = a;
        planes[at + 1] = b;
        planes[at + 2] = c;
        planes[at + 3] = d;
        // World coordinates of boxes and planes are rounded before they are made relative to the eye.
        double rounding = 0x1p-50 * farthest * (Math.abs(a) + Math.abs(b) + Math.abs(c));
        planes[at + 4] = Math.abs(d) * RELATIVE_SLACK + rounding;
    }

    /**
     * Returns false only if no part of the box can be visible; always false for an empty box, true for an unbounded
     * one. Allocates nothing.
     */
    public boolean mayIntersect(Aabb box) {
        if (box.isEmpty()) {
            return false;
        }
        return box.isUnbounded()
                || classify(box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ(), allPlanes())
                        != OUTSIDE;
    }

    /** Returns false only if no part of the bounding sphere of a box can be visible. */
    public boolean maySeeSphere(double[] bounds, int at) {
        double x = (bounds[at] + bounds[at + 3]) / 2;
        double y = (bounds[at + 1] + bounds[at + 4]) / 2;
        double z = (bounds[at + 2] + bounds[at + 5]) / 2;
        double halfX = bounds[at + 3] - bounds[at];
        double halfY = bounds[at + 4] - bounds[at + 1];
        double halfZ = bounds[at + 5] - bounds[at + 2];
        return mayIntersect(x, y, z, Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ) / 2);
    }

    /** Returns false only if no part of the ball can be visible; allocates nothing. */
    public boolean mayIntersect(double centreX, double centreY, double centreZ, double radius) {
        double x = centreX - eyeX;
        double y = centreY - eyeY;
        double z = centreZ - eyeZ;
        for (int p = 0; p < count * STRIDE; p += STRIDE) {
            double a = planes[p];
            double b = planes[p + 1];
            double c = planes[p + 2];
            double length = Math.sqrt(a * a + b * b + c * c);
            double reach = Math.abs(a * x) + Math.abs(b * y) + Math.abs(c * z) + length * radius;
            if (a * x + b * y + c * z + planes[p + 3] + length * radius < -(reach * RELATIVE_SLACK + planes[p + 4])) {
                return false;
            }
        }
        return true;
    }

    public double eyeX() {
        return eyeX;
    }

    public double eyeY() {
        return eyeY;
    }

    public double eyeZ() {
        return eyeZ;
    }

    /** Returns a mask with one bit for each plane. */
    public int allPlanes() {
        return (1 << count) - 1;
    }

    /**
     * Tests a box against the planes in {@code mask}.
     *
     * @param bounds minima and maxima, beginning at {@code at}
     * @param mask the planes that intersect an enclosing box
     * @return the planes that intersect this box, 0 if it is inside all of them, or {@link #OUTSIDE}
     */
    public int classify(double[] bounds, int at, int mask) {
        return classify(
                bounds[at], bounds[at + 1], bounds[at + 2], bounds[at + 3], bounds[at + 4], bounds[at + 5], mask);
    }

    private int classify(double left, double bottom, double back, double right, double top, double front, int mask) {
        double minX = left - eyeX;
        double minY = bottom - eyeY;
        double minZ = back - eyeZ;
        double maxX = right - eyeX;
        double maxY = top - eyeY;
        double maxZ = front - eyeZ;
        int cut = 0;
        for (int plane = 0; plane < count; plane++) {
            if ((mask & (1 << plane)) == 0) {
                continue;
            }
            int p = plane * STRIDE;
            double a = planes[p];
            double b = planes[p + 1];
            double c = planes[p + 2];
            double highX = a * (a >= 0 ? maxX : minX);
            double highY = b * (b >= 0 ? maxY : minY);
            double highZ = c * (c >= 0 ? maxZ : minZ);
            double slack = (Math.abs(highX) + Math.abs(highY) + Math.abs(highZ)) * RELATIVE_SLACK + planes[p + 4];
            if (highX + highY + highZ + planes[p + 3] < -slack) {
                return OUTSIDE;
            }
            double low = a * (a >= 0 ? minX : maxX) + b * (b >= 0 ? minY : maxY) + c * (c >= 0 ? minZ : maxZ);
            if (!(low + planes[p + 3] >= 0)) {
                cut |= 1 << plane;
            }
        }
        return cut;
    }
}
