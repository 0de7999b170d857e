package nephele.scenes.view;

import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The view angles of the viewer about a pole. At yaw 0 and pitch 0 it looks along {@code level.back()} reversed, with
 * the pole up.
 *
 * @param yawDegrees wrapped into −180 to 180, positive to the left
 * @param pitchDegrees clamped to −90 to 90, positive upwards
 */
public record ViewerAngles(Basis level, double yawDegrees, double pitchDegrees) {
    private static final double MOST_PITCH_DEGREES = 90;

    public ViewerAngles {
        yawDegrees = Math.IEEEremainder(finite(yawDegrees), 360);
        pitchDegrees = Math.max(-MOST_PITCH_DEGREES, Math.min(MOST_PITCH_DEGREES, finite(pitchDegrees)));
    }

    private static double finite(double degrees) {
        return Double.isFinite(degrees) ? degrees : 0;
    }

    /**
     * Returns the view angles from {@code eye} to {@code target}, or horizontal ones if both are one point. An up
     * vector that is parallel to that direction is replaced, as in {@link Basis#lookAt}; a zero one by y.
     */
    static ViewerAngles between(Vec3 eye, Vec3 target, Vec3 up) {
        Vec3 given = Directions.unit(up);
        Vec3 pole = given == null ? Basis.WORLD.up() : given;
        Basis looking = Basis.lookAt(eye, target, pole, null);
        if (looking == null) {
            Vec3 level = Directions.perpendicular(pole);
            looking = Basis.lookAt(Vec3.ZERO, level, pole, null);
        }
        double slope = Directions.angle(pole, looking.back()) - Math.PI / 2;
        Vec3 levelBack = looking.right().cross(pole);
        levelBack = Directions.unit(levelBack);
        Basis level = new Basis(pole.cross(levelBack), pole, levelBack);
        return new ViewerAngles(level, 0, StrictMath.toDegrees(slope));
    }

    /** Returns the view angles after a turn; an angle that is not finite counts as 0. */
    ViewerAngles turned(double leftDegrees, double upDegrees) {
        return new ViewerAngles(level, yawDegrees + finite(leftDegrees), pitchDegrees + finite(upDegrees));
    }

    Basis basis() {
        Basis turned = Basis.ofYawPitch(StrictMath.toRadians(yawDegrees), StrictMath.toRadians(pitchDegrees));
        return new Basis(inWorld(turned.right()), inWorld(turned.up()), inWorld(turned.back()));
    }

    private Vec3 inWorld(Vec3 v) {
        return Vec3.of(level.right()
                .toVector()
                .mul(v.x())
                .fma(v.y(), level.up().toVector())
                .fma(v.z(), level.back().toVector()));
    }
}
