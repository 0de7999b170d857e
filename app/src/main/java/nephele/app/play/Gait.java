package nephele.app.play;

import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerBody.Stance;
import nephele.engine.sim.PlayerState;
import nephele.engine.sim.SimState;
import org.joml.Vector3d;

/**
 * How the player's figure moves its limbs after a tick; nothing of the game depends on it.
 *
 * @param heightMetres from sole to crown, following the stance as the eye does
 * @param step of the walking cycle, 0 to 1 for left and right, by the distance walked
 * @param stride 0 standing, 1 walking, more running
 * @param airborne 0 on the ground, 1 in the air
 * @param carrying 0 with free hands, 1 with a thing before it
 */
record Gait(double heightMetres, double step, double stride, double airborne, double carrying) {
    /** The eye's rate in the simulation, so that the feet stay where they are when the player crouches. */
    private static final double HEIGHT_PER_SECOND = 15;

    private static final double LIMBS_PER_SECOND = 10;
    private static final double WALKING_METRES_PER_SECOND = 4;
    /** A whole cycle is longer the faster one goes: this, and so many metres for each metre a second. */
    private static final double SLOW_CYCLE_METRES = 1.6;

    private static final double CYCLE_SECONDS = 0.25;

    static final Gait STANDING = new Gait(Stance.STANDING.heightMetres(), 0, 0, 0, 0);

    /** After one more tick of this length that ended in {@code state}. */
    Gait next(SimState state, double seconds) {
        PlayerState player = state.player();
        boolean onGround = player.isGrounded();
        double speed = onGround ? speedAlongGround(player) : 0;
        double cycles = speed * seconds / (SLOW_CYCLE_METRES + CYCLE_SECONDS * speed);
        double limbs = -Math.expm1(-LIMBS_PER_SECOND * seconds);
        double toHeight = -Math.expm1(-HEIGHT_PER_SECOND * seconds);
        return new Gait(
                heightMetres + toHeight * (player.stance().heightMetres() - heightMetres),
                (step + cycles) % 1,
                stride + limbs * (speed / WALKING_METRES_PER_SECOND - stride),
                airborne + limbs * ((onGround ? 0 : 1) - airborne),
                carrying + limbs * ((state.around().holding().isHolding() ? 1 : 0) - carrying));
    }

    private static double speedAlongGround(PlayerState player) {
        Vec3 up = player.tilt().up();
        Vector3d velocity = player.velocity().toVector();
        return velocity.fma(-up.toVector().dot(velocity), up.toVector()).length();
    }

    /** Between this and the next tick's. */
    Gait towards(Gait later, double share) {
        double cycles = later.step - step;
        double onward = cycles < 0 ? cycles + 1 : cycles;
        return new Gait(
                mix(heightMetres, later.heightMetres, share),
                (step + onward * share) % 1,
                mix(stride, later.stride, share),
                mix(airborne, later.airborne, share),
                mix(carrying, later.carrying, share));
    }

    private static double mix(double a, double b, double share) {
        return a + (b - a) * share;
    }
}
