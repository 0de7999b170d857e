package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerBody.Stance;

/**
 * The player after a tick.
 *
 * @param feet where they are when upright: straight below the body's centre, also when the body leans
 * @param eyeMetres above the feet now, along the body; lags behind stairs and crouching so that the view moves smoothly
 * @param ground upward unit normal of what the player stands on, {@code null} in the air
 * @param jumpHeld whether jump was held in this tick: it has to be let go before the next jump
 * @param tilt how far a portal has left body and view from upright
 */
public record PlayerState(
        Vec3 feet,
        Vec3 velocity,
        Heading heading,
        double eyeMetres,
        Stance stance,
        Vec3 ground,
        boolean jumpHeld,
        Tilt tilt) {
    /** Upright. */
    public PlayerState(
            Vec3 feet, Vec3 velocity, Heading heading, double eyeMetres, Stance stance, Vec3 ground, boolean jumpHeld) {
        this(feet, velocity, heading, eyeMetres, stance, ground, jumpHeld, Tilt.UPRIGHT);
    }

    public static PlayerState standing(Vec3 feet, Heading heading) {
        return new PlayerState(feet, Vec3.ZERO, heading, Stance.STANDING.eyeMetres(), Stance.STANDING, null, false);
    }

    public boolean isGrounded() {
        return ground != null;
    }

    public PlayerState withVelocity(Vec3 changed) {
        return new PlayerState(feet, changed, heading, eyeMetres, stance, null, jumpHeld, tilt);
    }

    /** With what others gave it; off the ground or still on it. */
    PlayerState shoved(Vec3 changed, boolean staysOnGround) {
        return new PlayerState(
                feet, changed, heading, eyeMetres, stance, staysOnGround ? ground : null, jumpHeld, tilt);
    }

    /** Continues at another place, in the air until something is felt below. */
    public PlayerState withFeet(Vec3 changed) {
        return new PlayerState(changed, velocity, heading, eyeMetres, stance, null, jumpHeld, tilt);
    }

    /** The middle of the body: it is where the player is, on one side of every portal. */
    public Vec3 centre() {
        return new Vec3(feet.x(), feet.y() + stance.centreAboveFeet(), feet.z());
    }

    /** Where the eye is, of a leaning body too. */
    public Vec3 eye() {
        if (tilt.isBodyUpright()) {
            return new Vec3(feet.x(), feet.y() + eyeMetres, feet.z());
        }
        Vec3 centre = centre();
        double above = eyeMetres - stance.centreAboveFeet();
        Vec3 up = tilt.up();
        return centre.addScaled(above, up);
    }

    boolean isFinite() {
        return isFinite(feet) && isFinite(velocity) && Double.isFinite(eyeMetres) && tilt.isFinite();
    }

    private static boolean isFinite(Vec3 v) {
        return Double.isFinite(v.x()) && Double.isFinite(v.y()) && Double.isFinite(v.z());
    }

    long hash(long seed) {
        long hash = BitHash.join(BitHash.join(seed, feet), velocity);
        hash = BitHash.join(hash, heading.yawMillidegrees());
        hash = BitHash.join(hash, heading.pitchMillidegrees());
        hash = BitHash.join(hash, Double.doubleToLongBits(eyeMetres));
        hash = BitHash.join(hash, stance.ordinal());
        hash = ground == null ? BitHash.join(hash, 0) : BitHash.join(hash, ground);
        return tilt.hash(BitHash.join(hash, jumpHeld ? 1 : 0));
    }
}
