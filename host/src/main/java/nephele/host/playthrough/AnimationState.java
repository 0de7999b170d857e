package nephele.host.playthrough;

import nephele.engine.scene.dynamic.Gait;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;

/**
 * The animation state of the player's character after a tick. All of it changes smoothly; the simulation does not
 * depend on it.
 *
 * @param heightMetres from sole to crown, following the stance as the eye does
 * @param step phase of the walking cycle, 0 to 1
 * @param ahead speed in the direction of view, as a multiple of the walking speed; likewise {@code left}
 * @param airborne 0 on the ground, 1 in the air
 * @param carrying 0 with free hands, 1 with a held body
 */
record AnimationState(double heightMetres, double step, double ahead, double left, double airborne, double carrying) {
    /** The eye's rate in the simulation, so that the feet stay in place when the player crouches. */
    private static final double HEIGHT_PER_SECOND = 15;

    private static final double ANIMATION_PER_SECOND = 10;
    /** Stride below which the feet stay on the ground. */
    private static final double STANDING_STRIDE = 0.02;

    static final AnimationState STANDING = new AnimationState(Stance.STANDING.heightMetres(), 0, 0, 0, 0, 0);

    /** Returns the state after one more tick of this length, which ended in {@code state}. */
    AnimationState next(SimState state, double seconds) {
        PlayerState player = state.player();
        boolean onGround = player.isGrounded();
        double cos = Math.cos(player.heading().yawRadians());
        double sin = Math.sin(player.heading().yawRadians());
        double animation = -Math.expm1(-ANIMATION_PER_SECOND * seconds);
        double toHeight = -Math.expm1(-HEIGHT_PER_SECOND * seconds);
        double cycles = stride() < STANDING_STRIDE ? 0 : Gait.cyclesPerSecond(stride()) * seconds;
        return new AnimationState(
                mix(heightMetres, player.stance().heightMetres(), toHeight),
                (step + cycles) % 1,
                mix(ahead, onGround ? strides(player, -sin, -cos) : 0, animation),
                mix(left, onGround ? strides(player, -cos, sin) : 0, animation),
                mix(airborne, onGround ? 0 : 1, animation),
                mix(carrying, state.world().holding().isHolding() ? 1 : 0, animation));
    }

    /** Returns the speed along a direction (x, 0, z), as a multiple of the walking speed. */
    private static double strides(PlayerState player, double x, double z) {
        return (player.velocity().x() * x + player.velocity().z() * z) / Gait.WALKING_METRES_PER_SECOND;
    }

    /** Returns the speed as a multiple of the walking speed: 0 standing, 1 walking, more running. */
    double stride() {
        return Math.hypot(ahead, left);
    }

    /** Returns the direction of motion relative to the view: 0 ahead, positive to the left. */
    double travelRadians() {
        return Math.atan2(left, ahead);
    }

    /** Interpolates between this state and that of the next tick. */
    AnimationState towards(AnimationState later, double fraction) {
        double cycles = later.step - step;
        double onward = cycles < 0 ? cycles + 1 : cycles;
        return new AnimationState(
                mix(heightMetres, later.heightMetres, fraction),
                (step + onward * fraction) % 1,
                mix(ahead, later.ahead, fraction),
                mix(left, later.left, fraction),
                mix(airborne, later.airborne, fraction),
                mix(carrying, later.carrying, fraction));
    }

    private static double mix(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }
}
