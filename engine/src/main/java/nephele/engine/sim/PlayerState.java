package nephele.engine.sim;

import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerBody.Stance;

/**
 * The player after a tick.
 *
 * @param eyeMetres above the feet now; lags behind stairs and crouching so that the view moves smoothly
 * @param ground upward unit normal of what the player stands on, {@code null} in the air
 * @param jumpHeld whether jump was held in this tick: it has to be let go before the next jump
 */
public record PlayerState(
        Vec3 feet, Vec3 velocity, Heading heading, double eyeMetres, Stance stance, Vec3 ground, boolean jumpHeld) {
    public static PlayerState standing(Vec3 feet, Heading heading) {
        return new PlayerState(feet, Vec3.ZERO, heading, Stance.STANDING.eyeMetres(), Stance.STANDING, null, false);
    }

    public boolean isGrounded() {
        return ground != null;
    }

    public PlayerState withVelocity(Vec3 changed) {
        return new PlayerState(feet, changed, heading, eyeMetres, stance, null, jumpHeld);
    }

    /** Continues at another place, in the air until something is felt below. */
    public PlayerState withFeet(Vec3 changed) {
        return new PlayerState(changed, velocity, heading, eyeMetres, stance, null, jumpHeld);
    }

    boolean isFinite() {
        return isFinite(feet) && isFinite(velocity) && Double.isFinite(eyeMetres);
    }

    private static boolean isFinite(Vec3 v) {
        return Double.isFinite(v.x()) && Double.isFinite(v.y()) && Double.isFinite(v.z());
    }

    long hash(long seed) {
        long hash = StateHash.join(StateHash.join(seed, feet), velocity);
        hash = StateHash.join(hash, heading.yawMillidegrees());
        hash = StateHash.join(hash, heading.pitchMillidegrees());
        hash = StateHash.join(hash, Double.doubleToLongBits(eyeMetres));
        hash = StateHash.join(hash, stance.ordinal());
        hash = ground == null ? StateHash.join(hash, 0) : StateHash.join(hash, ground);
        return StateHash.join(hash, jumpHeld ? 1 : 0);
    }
}
