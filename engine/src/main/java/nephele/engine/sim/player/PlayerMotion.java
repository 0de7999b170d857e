package nephele.engine.sim.player;

import nephele.engine.collision.RoundedHull;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.Tilt;
import org.joml.Vector3d;

/** The mutable player during a tick. */
public final class PlayerMotion {
    /**
     * The greatest vertical share of a walker's speed that counts as rounding of a portal transform between level
     * portals.
     */
    private static final double LEVEL = 1e-9;

    /** The capsule's centre. */
    final Vector3d place = new Vector3d();

    final Vector3d velocity = new Vector3d();
    final Vector3d ground = new Vector3d();
    boolean grounded;
    double eye;
    private Stance stance;
    private PlayerView look;
    private RoundedHull shape;
    private double feetBefore;
    private double centreBefore;

    void load(PlayerState s) {
        stance = s.stance();
        feetBefore = s.feet().y();
        centreBefore = feetBefore + stance.centreAboveFeet();
        place.set(s.feet().x(), centreBefore, s.feet().z());
        velocity.set(s.velocity().x(), s.velocity().y(), s.velocity().z());
        eye = s.eyeMetres();
        look(new PlayerView(s.heading(), s.tilt()));
        // An upward velocity lifts the player off the ground.
        grounded = s.isGrounded() && velocity.y <= 0;
        if (grounded) {
            ground.set(s.ground().x(), s.ground().y(), s.ground().z());
        }
    }

    /**
     * Returns the state. The rise is added to the feet's old height, as repeated conversion between feet and centre
     * would accumulate rounding.
     */
    PlayerState store(boolean jumpHeld) {
        Vec3 feet = new Vec3(place.x, feetBefore + (place.y - centreBefore), place.z);
        Vec3 speed = new Vec3(velocity.x, velocity.y, velocity.z);
        Vec3 normal = grounded ? new Vec3(ground.x, ground.y, ground.z) : null;
        return new PlayerState(feet, speed, look.heading(), eye, stance, normal, jumpHeld, look.tilt());
    }

    Stance stance() {
        return stance;
    }

    PlayerView look() {
        return look;
    }

    /** Returns the capsule with its present tilt. */
    RoundedHull shape() {
        return shape;
    }

    void look(PlayerView changed) {
        look = changed;
        shape = shape(stance, look.tilt().up());
    }

    /** Returns the capsule of a stance along a body axis. */
    public static RoundedHull shape(Stance stance, Vec3 up) {
        if (up.equals(Tilt.UPRIGHT.up())) {
            return stance.shape();
        }
        double half = stance.heightMetres() / 2 - PlayerDimensions.RADIUS_METRES;
        return RoundedHull.capsule(up.scaled(half), PlayerDimensions.RADIUS_METRES);
    }

    /** Changes the stance; the feet stay where they are. */
    void change(Stance wanted) {
        double rise = wanted.centreAboveFeet() - stance.centreAboveFeet();
        Vec3 up = look.tilt().up();
        place.add(up.x() * rise, up.y() * rise, up.z() * rise);
        // The feet of an upright player keep their bits; the nominal feet of a leaning one move.
        feetBefore += rise * (up.y() - 1);
        centreBefore = place.y;
        stance = wanted;
        look(look);
    }

    /** Maps the player to the exit side of a portal. */
    void enter(PortalTransform transform) {
        transform.point(place);
        transform.direction(velocity);
        look(look.through(transform));
        feetBefore = place.y - stance.centreAboveFeet();
        centreBefore = place.y;
        if (!grounded) {
            return;
        }
        transform.direction(ground);
        grounded = ground.y >= PlayerDimensions.MIN_GROUND_NORMAL_Y;
        if (Math.abs(velocity.y) <= LEVEL * velocity.length()) {
            velocity.y = 0;
        }
    }
}
