package nephele.engine.level.billboard;

import nephele.engine.level.Billboards.Facing;
import nephele.engine.math.Vec3;

/**
 * The axes of a billboard's picture in the world, unit length. The twin of {@code facing} in {@code billboard.glsl}.
 *
 * @param right to the right in the picture
 * @param up upwards in the picture
 */
public record FacingAxes(Vec3 right, Vec3 up) {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /**
     * The square of the sine of the angle to the vertical below which a direction has no side: there the billboard takes
     * that of the view.
     */
    private static final double STEEP = 1e-8;

    /**
     * Returns the axes of an image that faces an eye.
     *
     * @param toEye from its middle, metres; any length
     * @param viewRight of the view, unit length
     * @param viewUp of the view, unit length
     * @param turn of crossed ones about the vertical axis, radians; the second image is a quarter turn further
     */
    public static FacingAxes of(Facing facing, Vec3 toEye, Vec3 viewRight, Vec3 viewUp, double turn) {
        return switch (facing) {
            case SPHERICAL -> spherical(toEye, viewRight);
            case CYLINDRICAL -> new FacingAxes(level(toEye, viewRight), UP);
            case SCREEN -> new FacingAxes(viewRight, viewUp);
            case CROSSED -> new FacingAxes(new Vec3(StrictMath.cos(turn), 0, -StrictMath.sin(turn)), UP);
            case SOURCE -> {
                double angle = sourceAngle(toEye.x(), toEye.z());
                yield new FacingAxes(new Vec3(StrictMath.cos(angle), 0, -StrictMath.sin(angle)), UP);
            }
        };
    }

    private static FacingAxes spherical(Vec3 toEye, Vec3 viewRight) {
        double length = toEye.length();
        if (!(length > 0)) {
            return new FacingAxes(level(toEye, viewRight), UP);
        }
        Vec3 right = level(toEye, viewRight);
        Vec3 up = toEye.scaled(1 / length).cross(right);
        return new FacingAxes(right, up.scaled(1 / up.length()));
    }

    /** Returns the horizontal direction to the right of one who looks at the billboard: up × towards the eye. */
    private static Vec3 level(Vec3 toEye, Vec3 viewRight) {
        double flat = toEye.x() * toEye.x() + toEye.z() * toEye.z();
        double square = flat + toEye.y() * toEye.y();
        if (flat > STEEP * square) {
            double length = StrictMath.sqrt(flat);
            return new Vec3(toEye.z() / length, 0, -toEye.x() / length);
        }
        double side = StrictMath.hypot(viewRight.x(), viewRight.z());
        return side > 1e-6 ? new Vec3(viewRight.x() / side, 0, viewRight.z() / side) : new Vec3(1, 0, 0);
    }

    /**
     * Returns the angle of the monograph of 2010 about the vertical axis, radians: atan((xe − xp) / (ze − zp)). It lacks
     * half a turn where ze &lt; zp, and 0 / 0 is 0 here.
     */
    public static double sourceAngle(double toEyeX, double toEyeZ) {
        double angle = StrictMath.atan(toEyeX / toEyeZ);
        return Double.isNaN(angle) ? 0 : angle;
    }

    /** Returns the direction to which the image's front points. */
    public Vec3 front() {
        return right.cross(up);
    }
}
