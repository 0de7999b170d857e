package nephele.engine.walk;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.scene.thing.Gait;
import nephele.engine.sim.PlayerBody.Stance;
import nephele.engine.sim.PlayerState;
import nephele.engine.sim.SimState;
import org.joml.Vector3d;

/**
 * How the player's figure moves its limbs after a tick, all of it smoothly; nothing of the game depends on it.
 *
 * @param heightMetres from sole to crown, following the stance as the eye does
 * @param step of the walking cycle, 0 to 1
 * @param ahead how fast it goes where it looks, in strides; {@code left} alike
 * @param airborne 0 on the ground, 1 in the air
 * @param carrying 0 with free hands, 1 with a thing before it
 */
record Limbs(double heightMetres, double step, double ahead, double left, double airborne, double carrying) {
    /** The eye's rate in the simulation, so that the feet stay where they are when the player crouches. */
    private static final double HEIGHT_PER_SECOND = 15;

    private static final double LIMBS_PER_SECOND = 10;
    /** Slower than this nobody lifts a foot. */
    private static final double STANDING_STRIDE = 0.02;

    static final Limbs STANDING = new Limbs(Stance.STANDING.heightMetres(), 0, 0, 0, 0, 0);

    /** After one more tick of this length that ended in {@code state}. */
    Limbs next(SimState state, double seconds) {
        PlayerState player = state.player();
        boolean onGround = player.isGrounded();
        Basis look = Basis.ofYawPitch(player.heading().yawRadians(), 0);
        double limbs = -Math.expm1(-LIMBS_PER_SECOND * seconds);
        double toHeight = -Math.expm1(-HEIGHT_PER_SECOND * seconds);
        double cycles = stride() < STANDING_STRIDE ? 0 : Gait.cyclesPerSecond(stride()) * seconds;
        return new Limbs(
                mix(heightMetres, player.stance().heightMetres(), toHeight),
                (step + cycles) % 1,
                mix(ahead, onGround ? -strides(player, look.back()) : 0, limbs),
                mix(left, onGround ? -strides(player, look.right()) : 0, limbs),
                mix(airborne, onGround ? 0 : 1, limbs),
                mix(carrying, state.around().holding().isHolding() ? 1 : 0, limbs));
    }

    /** Along an axis of the ground. */
    private static double strides(PlayerState player, Vec3 axis) {
        Vector3d velocity = player.velocity().toVector();
        return velocity.dot(axis.toVector()) / Gait.WALKING_METRES_PER_SECOND;
    }

    /** 0 standing, 1 walking, more running. */
    double stride() {
        return Math.hypot(ahead, left);
    }

    /** Where it goes, seen from where it looks: 0 ahead, positive to the left. */
    double travelRadians() {
        return Math.atan2(left, ahead);
    }

    /** Between this and the next tick's. */
    Limbs towards(Limbs later, double share) {
        double cycles = later.step - step;
        double onward = cycles < 0 ? cycles + 1 : cycles;
        return new Limbs(
                mix(heightMetres, later.heightMetres, share),
                (step + onward * share) % 1,
                mix(ahead, later.ahead, share),
                mix(left, later.left, share),
                mix(airborne, later.airborne, share),
                mix(carrying, later.carrying, share));
    }

    private static double mix(double a, double b, double share) {
        return a + (b - a) * share;
    }
}
