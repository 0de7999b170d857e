package nephele.app.view;

import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * Where the viewer looks: angles about a pole. At yaw 0 and pitch 0 it looks along {@code level.back()} reversed, with
 * the pole up.
 *
 * @param yawDegrees −180 to 180, positive to the left
 * @param pitchDegrees −90 to 90, positive upwards
 */
record Heading(Basis level, double yawDegrees, double pitchDegrees) {
    private static final double MOST_PITCH_DEGREES = 90;

    Heading {
        yawDegrees = Math.IEEEremainder(finite(yawDegrees), 360);
        pitchDegrees = Math.max(-MOST_PITCH_DEGREES, Math.min(MOST_PITCH_DEGREES, finite(pitchDegrees)));
    }

    private static double finite(double degrees) {
        return Double.isFinite(degrees) ? degrees : 0;
    }

    /**
     * From {@code eye} to {@code target}, or level where both are one point. An up that is parallel to that direction
     * gives way to another one, as in {@link Basis#lookAt}; a zero up is y.
     */
    static Heading between(Vec3 eye, Vec3 target, Vec3 up) {
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
        return new Heading(level, 0, StrictMath.toDegrees(slope));
    }

    /** What is not a finite angle turns nothing. */
    Heading turned(double leftDegrees, double upDegrees) {
        return new Heading(level, yawDegrees + finite(leftDegrees), pitchDegrees + finite(upDegrees));
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
