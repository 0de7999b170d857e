package nephele.engine.render.line;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import org.joml.Matrix4d;
import org.joml.Vector4d;

/** The projection of world points to a picture, in double precision and relative to the eye; immutable. */
public final class LineProjection {
    /** Lines on a surface are drawn this share of their distance in front of it. */
    private static final double NEARER_FRACTION = 1.5e-3;

    private final Vec3 eye;
    private final Matrix4d clipFromRelative;
    private final int width;
    private final int height;

    private LineProjection(Vec3 eye, Matrix4d clipFromRelative, int width, int height) {
        this.eye = eye;
        this.clipFromRelative = clipFromRelative;
        this.width = width;
        this.height = height;
    }

    /** Returns the projection of a view that a renderer has drawn into a picture of this size in pixels. */
    public static LineProjection of(View view, int width, int height) {
        return new LineProjection(view.eye(), view.clipFromRelative(new Matrix4d()), width, height);
    }

    /**
     * Returns a projection along {@code −frame.back()}, without depth.
     *
     * @param centre the point in the middle of the picture
     */
    public static LineProjection orthographic(Vec3 centre, Basis frame, double metresPerPixel, int width, int height) {
        double across = 2 / (metresPerPixel * width);
        double upwards = 2 / (metresPerPixel * height);
        Vec3 right = frame.right().scaled(across);
        Vec3 up = frame.up().scaled(upwards);
        Matrix4d matrix =
                new Matrix4d(right.x(), up.x(), 0, 0, right.y(), up.y(), 0, 0, right.z(), up.z(), 0, 0, 0, 0, 0, 1);
        return new LineProjection(centre, matrix, width, height);
    }

    /** Returns the picture's width in pixels. */
    public int width() {
        return width;
    }

    /** Returns the picture's height in pixels. */
    public int height() {
        return height;
    }

    /** Returns clip coordinates. */
    Vector4d clip(Vec3 point) {
        Vec3 relative = point.minus(eye);
        return clipFromRelative.transform(new Vector4d(relative.x(), relative.y(), relative.z(), 1));
    }

    /** Returns depth from −1 to 1, slightly nearer than the point, so that lines on a surface are visible. */
    double depth(Vector4d clip) {
        double nearer = clip.z + clipFromRelative.m32() * NEARER_FRACTION / (1 - NEARER_FRACTION);
        return Math.max(-1, Math.min(1, nearer / clip.w));
    }

    /** Returns x in pixels from the left border. */
    double pixelX(Vector4d clip) {
        return (clip.x / clip.w + 1) * width / 2;
    }

    /** Returns y in pixels from the lower border. */
    double pixelY(Vector4d clip) {
        return (clip.y / clip.w + 1) * height / 2;
    }

    /** Returns the vector from the eye to a point. */
    Vec3 fromEye(Vec3 point) {
        return point.minus(eye);
    }

    /** Returns the matrix from directions relative to the eye to clip space, with depth as {@link #depth} has it. */
    float[] matrix() {
        Matrix4d nearer = new Matrix4d(clipFromRelative);
        return nearer.m32(nearer.m32() / (1 - NEARER_FRACTION)).get(new float[16]);
    }
}
