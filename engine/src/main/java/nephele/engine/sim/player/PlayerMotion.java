package nephele.engine.sim.player;

import nephele.engine.collision.RoundedHull;
import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.Tilt;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The mutable player during a tick. Its centre crosses portals, which map the whole player to their other side. The
 * working set of one simulation.
 */
final class PlayerMotion {
    /**
     * The greatest vertical fraction of a walker's speed that counts as rounding of a portal transform between level
     * portals.
     */
    private static final double LEVEL = 1e-9;

    /**
     * The greatest number of crossings in a tick. The rest of the tick is then dropped, gravity included; the velocity
     * stays.
     */
    static final int MOST_HOPS = 8;

    private static final Vector3dc NO_ACCELERATION = new Vector3d();

    /** The capsule's centre. */
    final Vector3d place = new Vector3d();

    final Vector3d velocity = new Vector3d();
    /** The move intent: the horizontal velocity that the input requests, m/s. */
    final Vector3d intent = new Vector3d();

    final Vector3d ground = new Vector3d();
    boolean grounded;
    double eye;
    private Stance stance;
    private ViewAngles heading;
    private Tilt tilt;
    private RoundedHull shape;
    private double feetBefore;
    private double centreBefore;

    private final CharacterMover mover;
    private final PortalCrossing crossing = new PortalCrossing();
    /** The centre's place up to which portals have been crossed. */
    private final Vector3d tracked = new Vector3d();

    private final Vector3d path = new Vector3d();
    private Portals portals = Portals.NONE;
    private CrossingWord crossed = CrossingWord.EMPTY;
    private int hops;
    private boolean dropped;

    PlayerMotion(CharacterMover mover) {
        this.mover = mover;
    }

    void load(PlayerState s) {
        stance = s.stance();
        feetBefore = s.feet().y();
        centreBefore = feetBefore + stance.centreAboveFeet();
        place.set(s.feet().x(), centreBefore, s.feet().z());
        velocity.set(s.velocity().x(), s.velocity().y(), s.velocity().z());
        eye = s.eyeMetres();
        look(s.heading(), s.tilt());
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
        return new PlayerState(feet, speed, heading, eye, stance, normal, jumpHeld, tilt);
    }

    Stance stance() {
        return stance;
    }

    ViewAngles heading() {
        return heading;
    }

    Tilt tilt() {
        return tilt;
    }

    /** Returns the capsule with its present tilt. */
    RoundedHull shape() {
        return shape;
    }

    /** Sets the view, and the tilt of view and body. */
    void look(ViewAngles angles, Tilt tilted) {
        heading = angles;
        tilt = tilted;
        shape = stance.shape(tilt.up());
    }

    /** Sets {@link #intent} to the velocity that an input requests. */
    void intend(PlayerInput input) {
        double sin = StrictMath.sin(heading.yawRadians());
        double cos = StrictMath.cos(heading.yawRadians());
        double forward = input.forwardPercent() / 100.0;
        double right = input.rightPercent() / 100.0;
        intent.set(right * cos - forward * sin, 0, -right * sin - forward * cos);
        double length = intent.length();
        intent.mul(speed(input) / Math.max(1, length));
    }

    private double speed(PlayerInput input) {
        if (stance == Stance.CROUCHED) {
            return PlayerDimensions.CROUCH_METRES_PER_SECOND;
        }
        return input.holds(Action.RUN)
                ? PlayerDimensions.RUN_METRES_PER_SECOND
                : PlayerDimensions.WALK_METRES_PER_SECOND;
    }

    /** Changes the stance; the feet stay where they are. */
    void change(Stance wanted) {
        double rise = wanted.centreAboveFeet() - stance.centreAboveFeet();
        Vec3 up = tilt.up();
        place.add(up.x() * rise, up.y() * rise, up.z() * rise);
        // The feet of an upright player keep their bits; the nominal feet of a leaning one move.
        feetBefore += rise * (up.y() - 1);
        centreBefore = place.y;
        stance = wanted;
        look(heading, tilt);
    }

    /** Starts to follow the centre through portals, from its present place. */
    void track(Portals open) {
        portals = open;
        tracked.set(place);
        crossed = CrossingWord.EMPTY;
        hops = 0;
        dropped = false;
    }

    /** Returns the crossing word of this tick. */
    CrossingWord crossed() {
        return crossed;
    }

    /** Returns true if the rest of the tick was dropped, after {@link #MOST_HOPS}. */
    boolean hasDroppedTime() {
        return dropped;
    }

    boolean hasPortals() {
        return portals.size() > 0;
    }

    /** Returns the time at which the centre's arc first enters a portal; {@code seconds} if it enters none before. */
    double timeToEntry(Vector3dc acceleration, double seconds) {
        boolean enters = crossing.find(portals, place, velocity, acceleration, seconds);
        if (enters && hops == MOST_HOPS) {
            dropped = true;
        }
        return enters ? crossing.seconds() : seconds;
    }

    /** Moves the player through the portal found last, from the exact point of entry. */
    void enterFound() {
        place.set(crossing.place());
        pass();
        tracked.set(place);
    }

    /** Moves the player through every portal that the straight segment from its last tracked place enters. */
    void crossPortals() {
        if (!hasPortals()) {
            return;
        }
        place.sub(tracked, path);
        while (!dropped && crossing.find(portals, tracked, path, NO_ACCELERATION, 1)) {
            if (hops == MOST_HOPS) {
                place.set(tracked);
                dropped = true;
                return;
            }
            portals.transform(crossing.portal()).point(tracked.set(crossing.place()));
            portals.transform(crossing.portal()).direction(path.mul(1 - crossing.seconds()));
            pass();
        }
        tracked.set(place);
    }

    private void pass() {
        int entered = crossing.portal();
        map(portals.transform(entered));
        crossed = crossed.then(entered, portals);
        hops++;
        mover.resetAfterPortal();
    }

    /** Maps the player to the exit side of a portal. */
    private void map(PortalTransform transform) {
        transform.point(place);
        transform.direction(velocity);
        mapView(transform);
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

    /**
     * Maps the view exactly: the view angles hold what fits into whole thousandths of a degree, the tilt the remainder.
     */
    private void mapView(PortalTransform transform) {
        Basis view = transform.basis(tilt.view(heading));
        ViewAngles nearest = ViewAngles.nearest(view.up(), view.back());
        Basis level = Basis.ofYawPitch(nearest.yawRadians(), nearest.pitchRadians());
        Quaterniond rest = Rotations.ofAxes(view.right(), view.up(), view.back());
        rest.mul(Rotations.ofAxes(level.right(), level.up(), level.back()).conjugate());
        look(nearest, Tilt.of(transform.direction(tilt.up()), Rotations.normalised(rest)));
    }
}
