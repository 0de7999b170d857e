package nephele.engine.sim.state;

import nephele.engine.math.Basis;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import org.joml.Vector3d;

/**
 * The player after a tick.
 *
 * @param feet the position of the feet of an upright player: straight below the body's centre, also if the body leans
 * @param velocity m/s
 * @param eyeMetres the eye's present height above the feet, along the body; lags behind stairs and crouching so that
 *     the view moves smoothly
 * @param ground upward unit normal of the ground, {@code null} in the air
 * @param jumpHeld true if jump was held in this tick: it has to be released before the next jump
 * @param tilt the deviation of body and view from upright, left by a portal
 */
public record PlayerState(
        Vec3 feet,
        Vec3 velocity,
        ViewAngles heading,
        double eyeMetres,
        Stance stance,
        Vec3 ground,
        boolean jumpHeld,
        Tilt tilt) {
    /** Creates an upright player. */
    public PlayerState(
            Vec3 feet,
            Vec3 velocity,
            ViewAngles heading,
            double eyeMetres,
            Stance stance,
            Vec3 ground,
            boolean jumpHeld) {
        this(feet, velocity, heading, eyeMetres, stance, ground, jumpHeld, Tilt.UPRIGHT);
    }

    /** Returns an upright standing player at rest, not yet on the ground. */
    public static PlayerState standing(Vec3 feet, ViewAngles heading) {
        return new PlayerState(feet, Vec3.ZERO, heading, Stance.STANDING.eyeMetres(), Stance.STANDING, null, false);
    }

    /** Returns true if the player is on the ground. */
    public boolean isGrounded() {
        return ground != null;
    }

    /** Returns this player with another velocity (m/s), in the air. */
    public PlayerState withVelocity(Vec3 changed) {
        return new PlayerState(feet, changed, heading, eyeMetres, stance, null, jumpHeld, tilt);
    }

    /** Returns this player with the velocity after pushes by bodies, off the ground or still on it. */
    public PlayerState shoved(Vec3 changed, boolean staysOnGround) {
        return new PlayerState(
                feet, changed, heading, eyeMetres, stance, staysOnGround ? ground : null, jumpHeld, tilt);
    }

    /** Returns this player with its feet elsewhere, in the air until it touches ground. */
    public PlayerState withFeet(Vec3 changed) {
        return new PlayerState(changed, velocity, heading, eyeMetres, stance, null, jumpHeld, tilt);
    }

    /** Returns the body's centre. It is the player's position, and decides the side of every portal. */
    public Vec3 centre() {
        return new Vec3(feet.x(), feet.y() + stance.centreAboveFeet(), feet.z());
    }

    /** Returns the eye, also of a leaning body, as if no portal were between it and the centre. */
    public Vec3 eye() {
        if (tilt.isBodyUpright()) {
            return new Vec3(feet.x(), feet.y() + eyeMetres, feet.z());
        }
        Vec3 centre = centre();
        double above = eyeMetres - stance.centreAboveFeet();
        Vec3 up = tilt.up();
        return centre.addScaled(above, up);
    }

    /** Returns the path from the body's centre to the eye, which may be beyond a portal. */
    public PathTrace pathToEye(Portals portals) {
        var path = new PathTrace(portals, Obstacles.NONE);
        Vector3d centre = centre(new Vector3d());
        path.trace(centre, eye(new Vector3d()).sub(centre));
        return path;
    }

    /** Sets {@code out} to the body's centre and returns it. */
    public Vector3d centre(Vector3d out) {
        return set(centre(), out);
    }

    /** Sets {@code out} to the eye, as if no portal were between it and the centre, and returns it. */
    public Vector3d eye(Vector3d out) {
        return set(eye(), out);
    }

    private static Vector3d set(Vec3 v, Vector3d out) {
        return out.set(v.x(), v.y(), v.z());
    }

    /** Returns the camera basis of the view, in the space of the centre. */
    public Basis view() {
        return tilt.view(heading);
    }

    /** Sets {@code out} to the unit view direction, in the space of the centre, and returns it. */
    public Vector3d ahead(Vector3d out) {
        Vec3 back = view().back();
        return out.set(-back.x(), -back.y(), -back.z());
    }

    public boolean isFinite() {
        return isFinite(feet) && isFinite(velocity) && Double.isFinite(eyeMetres) && tilt.isFinite();
    }

    private static boolean isFinite(Vec3 v) {
        return Double.isFinite(v.x()) && Double.isFinite(v.y()) && Double.isFinite(v.z());
    }

    long hash(long seed) {
        long hash = Hash64.combine(Hash64.combine(seed, feet), velocity);
        hash = Hash64.combine(hash, heading.yawMillidegrees());
        hash = Hash64.combine(hash, heading.pitchMillidegrees());
        hash = Hash64.combine(hash, Double.doubleToLongBits(eyeMetres));
        hash = Hash64.combine(hash, stance.ordinal());
        hash = ground == null ? Hash64.combine(hash, 0) : Hash64.combine(hash, ground);
        return tilt.hash(Hash64.combine(hash, jumpHeld ? 1 : 0));
    }
}
