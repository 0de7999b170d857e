package nephele.engine.math;

import java.util.Arrays;
import org.joml.Matrix4dc;

/**
 * The half spaces that a view can see, relative to its eye. Conservative: a box that clipping would leave a part of is
 * never outside, also after the graphics hardware has rounded to float.
 */
public final class Frustum {
    /** The answer of {@link #classify} for a box that is outside. */
    static final int OUTSIDE = -1;

    /** Float transforms round at 2⁻²⁴; four times that share of the magnitudes involved decides for "inside". */
    private static final double RELATIVE_SLACK = 0x1p-22;

    /** A normal this short, relative to the matrix, is an infinite far plane that rounding has touched. */
    private static final double NULL_NORMAL = 1e-12;

    private static final int STRIDE = 5;

    /** a, b, c, d and absolute slack of each half space a·x + b·y + c·z + d ≥ 0, x relative to the eye. */
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
     * The planes of Gribb and Hartmann 2001, section 2, kept at the matrix' own scale. A far plane at infinity has no
     * normal and bounds nothing.
     *
     * @param clipFromRelative projection · rotation, for positions relative to {@code eye}
     */
    public static Frustum of(Matrix4dc clipFromRelative, Vec3 eye) {
        Frustum frustum = reusable(6);
        frustum.restart(eye.x(), eye.y(), eye.z());
        frustum.keepAll(clipFromRelative);
        return frustum;
    }

    /** Also cuts away, from a {@link #reusable} frustum, what a matrix as in {@link #of} projects out of the picture. */
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

    /** Without bounds. */
    public static Frustum everything() {
        return new Frustum(new double[0], 0, 0, 0, 0);
    }

    /** Also cuts away what lies behind {@code plane}, given in the world. */
    public Frustum inFrontOf(Plane plane) {
        double[] more = Arrays.copyOf(planes, (count + 1) * STRIDE);
        Frustum cut = new Frustum(more, count, eyeX, eyeY, eyeZ);
        cut.keepInFrontOf(plane);
        return cut;
    }

    /** One that is filled anew for every frame, with at most so many half spaces. */
    public static Frustum reusable(int mostPlanes) {
        return new Frustum(new double[mostPlanes * STRIDE], 0, 0, 0, 0);
    }

    /** Makes a {@link #reusable} frustum see everything around an eye. */
    public void restart(double newEyeX, double newEyeY, double newEyeZ) {
        count = 0;
        eyeX = newEyeX;
        eyeY = newEyeY;
        eyeZ = newEyeZ;
    }

    /** Also cuts away, from a {@link #reusable} frustum, where a·x + b·y + c·z + d is negative, x relative to the eye. */
    public void keep(double a, double b, double c, double d) {
        put(planes, count++ * STRIDE, a, b, c, d, Math.max(Math.abs(eyeX), Math.max(Math.abs(eyeY), Math.abs(eyeZ))));
    }

    /** Also cuts away, from a {@link #reusable} frustum, what lies behind {@code plane}, given in the world. */
    public void keepInFrontOf(Plane plane) {
        keep(plane.nx(), plane.ny(), plane.nz(), plane.signedDistance(eyeX, eyeY, eyeZ));
    }

    private static void put(double[] planes, int at, double a, double b, double c, double d, double farthest) {
        planes[at] = a;
        planes[at + 1] = b;
        planes[at + 2] = c;
        planes[at + 3] = d;
        // Boxes and planes are rounded where the eye is before they become relative to it.
        double rounding = 0x1p-50 * farthest * (Math.abs(a) + Math.abs(b) + Math.abs(c));
        planes[at + 4] = Math.abs(d) * RELATIVE_SLACK + rounding;
    }

    /** False only when no part of the box can be visible; an empty box never is, one with an infinite side always. */
    public boolean maySee(Aabb box) {
        if (box.isEmpty()) {
            return false;
        }
        double[] bounds = {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()};
        return Aabb.isUnbounded(bounds, 0) || classify(bounds, 0, allPlanes()) != OUTSIDE;
    }

    /** False only when no part of the sphere around a box can be visible. */
    boolean maySeeSphere(double[] bounds, int at) {
        double x = (bounds[at] + bounds[at + 3]) / 2;
        double y = (bounds[at + 1] + bounds[at + 4]) / 2;
        double z = (bounds[at + 2] + bounds[at + 5]) / 2;
        double halfX = bounds[at + 3] - bounds[at];
        double halfY = bounds[at + 4] - bounds[at + 1];
        double halfZ = bounds[at + 5] - bounds[at + 2];
        return maySee(x, y, z, Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ) / 2);
    }

    /** False only when no part of the ball can be visible; allocates nothing. */
    public boolean maySee(double centreX, double centreY, double centreZ, double radius) {
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

    double eyeX() {
        return eyeX;
    }

    double eyeY() {
        return eyeY;
    }

    double eyeZ() {
        return eyeZ;
    }

    /** One bit for each plane. */
    int allPlanes() {
        return (1 << count) - 1;
    }

    /**
     * @param bounds minima and maxima from {@code at} on
     * @param mask the planes that a box around this one cuts
     * @return the planes this box cuts, 0 when it is inside all of them, or {@link #OUTSIDE}
     */
    int classify(double[] bounds, int at, int mask) {
        double minX = bounds[at] - eyeX;
        double minY = bounds[at + 1] - eyeY;
        double minZ = bounds[at + 2] - eyeZ;
        double maxX = bounds[at + 3] - eyeX;
        double maxY = bounds[at + 4] - eyeY;
        double maxZ = bounds[at + 5] - eyeZ;
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
