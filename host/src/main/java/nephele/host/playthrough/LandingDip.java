package nephele.host.playthrough;

import nephele.engine.math.Vec3;
import nephele.engine.sim.state.SimState;

/**
 * The displacement by which the eye and the character's body sink after a landing and come back, the farther the faster the
 * landing was: the spring of {@link CameraSpring}. A function of the ticks; the simulation does not depend on it.
 */
record LandingDip(CameraSpring spring) {
    static final LandingDip NONE = new LandingDip(CameraSpring.AT_REST);

    /** A step down lands with less, and is not felt. */
    private static final double LEAST_LANDING = 2.2;
    /** Velocity of the spring per velocity of the landing beyond that. */
    private static final double SPRING_FRACTION = 0.42;

    private static final double MOST_SPRING_VELOCITY = 6;
    /** Below this the spring is at rest. */
    private static final double REST_METRES = 1e-5;

    /** Returns the dip after one more tick of this length. */
    LandingDip next(SimState before, SimState after, double seconds) {
        double speed = landing(before, after);
        if (speed == 0 && spring == CameraSpring.AT_REST) {
            return this;
        }
        double pushed = Math.min(MOST_SPRING_VELOCITY, SPRING_FRACTION * speed);
        Vec3 velocity = spring.velocity().plus(new Vec3(0, -pushed, 0));
        CameraSpring now = new CameraSpring(spring.lag(), velocity).after(seconds);
        boolean isAtRest =
                Math.abs(now.lag().y()) < REST_METRES && Math.abs(now.velocity().y()) < REST_METRES;
        return isAtRest ? NONE : new LandingDip(now);
    }

    /** Returns the speed of a landing in the tick beyond that of a step, m/s; 0 without one. */
    private static double landing(SimState before, SimState after) {
        boolean lands = !before.player().isGrounded() && after.player().isGrounded();
        boolean hasCrossed = after.world().trace().playerCrossed().length() > 0;
        return lands && !hasCrossed ? Math.max(0, -before.player().velocity().y() - LEAST_LANDING) : 0;
    }

    /** Returns the metres below the usual height between this tick and the next one. */
    double metres(LandingDip later, double fraction) {
        return -(spring.lag().y() + (later.spring.lag().y() - spring.lag().y()) * fraction);
    }
}
