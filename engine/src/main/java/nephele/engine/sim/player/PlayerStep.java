package nephele.engine.sim.player;

import static nephele.engine.sim.state.PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;

import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.Tilt;
import nephele.engine.sim.state.ViewAngles;
import nephele.engine.sim.state.WorldState;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Steps the player by one tick: look, stance, jump, walk or flight, through portals too. The working set of one
 * simulation.
 */
public final class PlayerStep {
    /** The speed in m/s below which a player without move intent stops, as the exponential would never end. */
    private static final double AT_REST_METRES_PER_SECOND = 1e-4;

    /** The radius of the sphere that keeps the eye clear of ceilings, metres. */
    private static final double HEAD_RADIUS_METRES = 0.1;

    private static final RoundedHull HEAD = RoundedHull.sphere(HEAD_RADIUS_METRES);

    private static final double UPRIGHT_RADIANS_PER_SECOND = 2 * Math.PI;
    /**
     * The greatest angle of one rotation step. The head, 0.6 m from the centre, moves 3 cm in it: a tenth of the
     * capsule's radius.
     */
    private static final double MOST_TURN_RADIANS = Math.PI / 60;

    private static final double TURN_AHEAD_SECONDS = 0.3;

    /** The distance to walls beside an exit that {@link Assist#EXIT_ROOM} makes. */
    private static final double EXIT_ROOM_METRES = 0.2;

    private static final double MOST_EASING_METRES_PER_SECOND = 1;

    /** The speed for each metre that is missing, 1/s. */
    private static final double EASING_RATE_PER_SECOND = 8;

    /** The player counts as at the exit up to so far before it, and aside of its aperture. */
    private static final double BEFORE_EXIT_METRES = 1;

    /** Solids that are nearest at most so far before the exit's plane are its wall and its frame. */
    private static final double EXIT_FRAME_METRES = 0.05;

    /** Surfaces that are flatter are floors, ceilings and slopes: the least horizontal part of a unit normal. */
    private static final double LEAST_LEVEL = 0.7;

    private final double seconds;
    /** The angles by which body and view turn upright in a tick. */
    private final double uprightRadians;

    private final double viewUprightRadians;
    private final ExponentialApproach groundDamping;
    private final ExponentialApproach eyeDamping;
    private final CharacterMover mover;
    private final GroundWalk walk;
    private final AirFlight flight;
    /** {@code null} without the assist. */
    private final WalkIn walkIn;

    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final Vector3d easing = new Vector3d();
    private final Vector3d axis = new Vector3d();
    private final Depenetration depenetration = new Depenetration();
    private final PlayerMotion player;
    private final Vector3d path = new Vector3d();
    private final Vector3d head = new Vector3d();
    private final Vector3d raised = new Vector3d();

    public PlayerStep(BodyTable bodies, SimSettings settings) {
        double seconds = 1.0 / settings.ticksPerSecond();
        this.seconds = seconds;
        mover = new CharacterMover(new BodyObstacles(bodies));
        player = new PlayerMotion(mover);
        walk = new GroundWalk(mover);
        flight = new AirFlight(mover, walk);
        walkIn = settings.assists().contains(Assist.WALK_IN) ? new WalkIn() : null;
        groundDamping = ExponentialApproach.of(PlayerDimensions.GROUND_RATE_PER_SECOND, seconds);
        eyeDamping = ExponentialApproach.of(PlayerDimensions.EYE_RATE_PER_SECOND, seconds);
        uprightRadians = UPRIGHT_RADIANS_PER_SECOND * seconds;
        boolean isAsBody = settings.uprightDegreesPerSecond() == SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
        viewUprightRadians = isAsBody ? uprightRadians : Math.toRadians(settings.uprightDegreesPerSecond()) * seconds;
    }

    /** @param around the world state; its bodies are obstacles, except the one that does not collide with the player */
    public PlayerState step(PortalWorld world, WorldState around, PlayerState before, PlayerInput input) {
        boolean isEmpty = world.statics().size() == 0;
        ViewAngles heading = before.heading().turned(input.turnLeftMillidegrees(), input.turnUpMillidegrees());
        load(before, heading, isEmpty);
        mover.enter(world, around.bodies(), around.holding().passing());
        player.track(world.portals());
        changeStance(input.holds(Action.CROUCH));
        if (recover()) {
            turnUpright();
            player.crossPortals();
            settle();
            if (around.arrival().isRecent()) {
                ease(world.portals().portal(around.arrival().portal()), input);
            }
            if (player.grounded && !isEmpty && input.holds(Action.JUMP) && !before.jumpHeld()) {
                jump();
            }
            if (player.grounded) {
                walkOnGround(input, world.portals());
            } else {
                flight.fly(player, input, seconds);
            }
        }
        player.crossPortals();
        mover.pushes().settle(player, seconds);
        player.eye = eyeDamping.approach(player.eye, player.stance().eyeMetres());
        return player.store(input.holds(Action.JUMP));
    }

    /** Returns the player's contacts with bodies in the last tick. */
    public BodyPushes pushes() {
        return mover.pushes();
    }

    /** Returns the crossing word of the last tick. */
    public CrossingWord crossed() {
        return player.crossed();
    }

    /** Returns true if the last tick had more crossings than allowed and ended at the last allowed one. */
    public boolean hasDroppedTime() {
        return player.hasDroppedTime();
    }

    private void load(PlayerState before, ViewAngles heading, boolean isEmpty) {
        player.load(before);
        player.look(heading, before.tilt());
        if (!player.grounded && isEmpty) {
            // Without any static geometry the player hovers.
            player.grounded = true;
            player.ground.set(0, 1, 0);
        }
    }

    /**
     * Changes the stance with the feet in place. Standing up waits for head room: the low capsule swept upwards covers
     * the high one.
     */
    private void changeStance(boolean wantsCrouch) {
        Stance wanted = wantsCrouch ? Stance.CROUCHED : Stance.STANDING;
        if (wanted == player.stance()) {
            return;
        }
        double rise = wanted.heightMetres() - player.stance().heightMetres();
        var up = player.tilt().up();
        path.set(up.x() * rise, up.y() * rise, up.z() * rise);
        if (wantsCrouch || !mover.isBlocked(player.shape(), player.place, path)) {
            player.change(wanted);
        }
    }

    /** Pushes the player out of solids, a little each tick. Returns false while it is still inside. */
    private boolean recover() {
        RoundedHull shape = player.shape();
        depenetration.find(mover.world(shape, player.place), shape, player.place, path);
        double needed = path.length();
        if (needed == 0) {
            return true;
        }
        double pushed = Math.min(needed, PlayerDimensions.DEPENETRATION_METRES_PER_TICK);
        player.place.add(path.mul(pushed / needed));
        if (pushed < needed) {
            player.velocity.zero();
            player.grounded = false;
            return false;
        }
        return true;
    }

    /**
     * Turns a player upright that came out of a portal tilted. The view turns at once, at a rate that the player can
     * choose. The body turns about its centre as far as there is room, never into a solid; in an aperture it waits
     * while turning would make it hit the rim.
     */
    private void turnUpright() {
        Tilt tilt = player.tilt();
        if (tilt.isUpright()) {
            return;
        }
        ViewAngles heading = player.heading();
        player.look(heading, tilt.viewTowardsUpright(viewUprightRadians));
        int left = (int) Math.ceil(uprightRadians / MOST_TURN_RADIANS);
        double angle = uprightRadians / left;
        while (left > 0 && turnBody(heading, angle)) {
            left--;
        }
    }

    /** Turns the body by an angle too small to skip an obstacle. Returns false if it is upright or has no room. */
    private boolean turnBody(ViewAngles heading, double angle) {
        Tilt tilt = player.tilt();
        if (tilt.isBodyUpright()) {
            return false;
        }
        Vec3 up = tilt.bodyTowardsUpright(angle, forward(heading));
        RoundedHull turned = player.stance().shape(up);
        if (!standsUp(turned) && !hasRoom(turned)) {
            return false;
        }
        player.look(heading, tilt.withBody(up));
        return true;
    }

    private static Vec3 forward(ViewAngles heading) {
        return new Vec3(-StrictMath.sin(heading.yawRadians()), 0, -StrictMath.cos(heading.yawRadians()));
    }

    private boolean hasRoom(RoundedHull turned) {
        if (!depenetration.isFree(mover.world(turned, player.place), turned, player.place)) {
            return false;
        }
        if (mover.active() == 0) {
            return true;
        }
        path.set(player.velocity).mul(TURN_AHEAD_SECONDS);
        mover.isBlocked(player.shape(), player.place, path);
        double free = mover.lastSweep().fraction();
        mover.isBlocked(turned, player.place, path);
        return mover.lastSweep().fraction() >= free;
    }

    /**
     * Raises a grounded player by as much as its capsule reaches further down after the turn. Returns true if that
     * makes room.
     */
    private boolean standsUp(RoundedHull turned) {
        double rise = player.shape().least(1) - turned.least(1);
        if (!(rise > 0) || !player.grounded) {
            return false;
        }
        raised.set(player.place);
        if (mover.advanceUntilHit(player.shape(), raised, path.set(0, rise, 0))) {
            return false;
        }
        boolean free = depenetration.isFree(mover.world(turned, raised), turned, raised);
        if (free) {
            player.place.set(raised);
        }
        return free;
    }

    /** Grounds a player that was placed onto ground, at once. */
    private void settle() {
        if (!player.grounded && player.velocity.y == 0 && walk.land(player.shape(), player.place)) {
            player.grounded = true;
            player.ground.set(walk.ground());
        }
    }

    /** Eases a player that has come out of a portal off what is close; one on the ground only as far as ground is below. */
    private void ease(Portal exit, PlayerInput input) {
        player.intend(input);
        RoundedHull shape = player.shape();
        easing(exit, mover.world(shape, player.place)).mul(seconds, path);
        if (path.lengthSquared() == 0) {
            return;
        }
        if (!player.grounded) {
            mover.slide(shape, player.place, path);
            return;
        }
        head.set(player.place);
        boolean stands = walk.walk(shape, player.place, path, player.ground);
        path.set(0, -player.stance().heightMetres() / 2 - PlayerDimensions.STEP_METRES / 2, 0);
        if (stands && mover.isBlocked(HEAD, player.place, path)) {
            player.ground.set(walk.ground());
        } else {
            player.place.set(head);
        }
    }

    /**
     * Returns the horizontal velocity, m/s, by which {@link Assist#EXIT_ROOM} eases a player that has come out of a portal
     * sideways off the walls and edges before it; zero if it has room or is away from the exit. It moves only across the
     * direction of a held key, and never back towards the portal.
     */
    private Vector3dc easing(Portal exit, CollisionWorld world) {
        easing.zero();
        if (!isAt(exit)) {
            return easing;
        }
        RoundedHull shape = player.shape();
        Vector3d at = player.place;
        world.overlapping(
                new Aabb(
                        at.x + shape.least(0) - EXIT_ROOM_METRES,
                        at.y + shape.least(1),
                        at.z + shape.least(2) - EXIT_ROOM_METRES,
                        at.x + shape.greatest(0) + EXIT_ROOM_METRES,
                        at.y + shape.greatest(1),
                        at.z + shape.greatest(2) + EXIT_ROOM_METRES),
                near);
        for (int i = 0; i < near.size(); i++) {
            Collider solid = world.collider(near.get(i));
            separation.measure(shape, at.x, at.y, at.z, solid);
            double missing = EXIT_ROOM_METRES - separation.metres();
            axis.set(separation.normal().x(), 0, separation.normal().z());
            if (missing > 0 && axis.length() > LEAST_LEVEL && isBefore(exit)) {
                raise(axis.normalize(), missing * EASING_RATE_PER_SECOND);
            }
        }
        axis.set(exit.normal().x(), 0, exit.normal().z());
        remove(axis, Math.min(0, easing.dot(axis)));
        remove(axis.set(player.intent), easing.dot(axis));
        double speed = easing.length();
        return speed > MOST_EASING_METRES_PER_SECOND ? easing.mul(MOST_EASING_METRES_PER_SECOND / speed) : easing;
    }

    private boolean isAt(Portal exit) {
        Vector3d at = player.place;
        double before = exit.inFront(at.x, at.y, at.z);
        double across = exit.across(at.x, at.y, at.z);
        double upward = exit.upward(at.x, at.y, at.z);
        return before >= 0
                && before <= BEFORE_EXIT_METRES
                && exit.aperture().outside(across, upward) <= BEFORE_EXIT_METRES
                && player.velocity.length() <= PlayerDimensions.RUN_METRES_PER_SECOND + 1e-9;
    }

    private boolean isBefore(Portal exit) {
        return exit.inFront(separation.onCollider(0), separation.onCollider(1), separation.onCollider(2))
                > EXIT_FRAME_METRES;
    }

    /** Raises the velocity along a unit vector to a least value. */
    private void raise(Vector3dc along, double least) {
        easing.fma(Math.max(0, least - easing.dot(along)), along);
    }

    /** Removes a fraction of a vector from the velocity; {@code dot} is the scalar product of both that is taken out. */
    private void remove(Vector3dc vector, double dot) {
        double square = vector.lengthSquared();
        if (square > 0) {
            easing.fma(-dot / square, vector);
        }
    }

    /** Sets the vertical speed for a ballistic apex of exactly the jump height. */
    private void jump() {
        player.velocity.y = Math.sqrt(2 * GRAVITY_METRES_PER_SECOND_SQUARED * PlayerDimensions.JUMP_METRES);
        player.grounded = false;
    }

    private void walkOnGround(PlayerInput input, Portals portals) {
        player.intend(input);
        boolean isLed = walkIn != null && walkIn.lead(player, portals, seconds);
        Vector3d velocity = player.velocity;
        path.set(
                groundDamping.displacement(velocity.x, player.intent.x),
                0,
                groundDamping.displacement(velocity.z, player.intent.z));
        velocity.set(
                groundDamping.approach(velocity.x, player.intent.x),
                0,
                groundDamping.approach(velocity.z, player.intent.z));
        if (player.intent.lengthSquared() == 0 && velocity.length() < AT_REST_METRES_PER_SECOND) {
            velocity.zero();
            path.zero();
        }
        mover.pushes().intent(velocity);
        double height = player.place.y;
        double slope = -(player.ground.x * path.x + player.ground.z * path.z) / player.ground.y;
        player.grounded = isLed
                ? walk.walkOverFrames(player.shape(), player.place, path, player.ground)
                : walk.walk(player.shape(), player.place, path, player.ground);
        player.ground.set(walk.ground());
        walk.walls().removeComponentsInto(velocity);
        smoothEye(player.place.y - height - slope);
    }

    /**
     * Lets the eye lag when the feet step up or down. It stays within the body or, on the way down, in free air above
     * it.
     */
    private void smoothEye(double suddenRise) {
        player.eye = Math.max(PlayerDimensions.RADIUS_METRES, player.eye - suddenRise);
        double inHead = player.stance().heightMetres() - HEAD_RADIUS_METRES;
        if (player.eye > inHead) {
            path.set(0, player.eye - inHead, 0);
            double headAboveCentre = inHead - player.stance().centreAboveFeet();
            head.set(player.place.x, player.place.y + headAboveCentre, player.place.z);
            mover.isBlocked(HEAD, head, path);
            player.eye = inHead + mover.lastSweep().fraction() * path.y;
        }
    }

    /**
     * The exponential approach to a target over one tick, in closed form: v' = k (target − v) has v(t) = target + (v₀ −
     * target) exp(−k t), with the displacement target · t + (v₀ − target)(1 − exp(−k t)) / k. It never overshoots, and two
     * half ticks equal a whole one.
     *
     * @param fraction 1 − exp(−k t), the part of the difference that a tick removes
     * @param displacementPerSpeed (1 − exp(−k t)) / k, in seconds
     * @param seconds the tick's length
     */
    public record ExponentialApproach(double fraction, double displacementPerSpeed, double seconds) {
        public static ExponentialApproach of(double ratePerSecond, double seconds) {
            double fraction = -StrictMath.expm1(-ratePerSecond * seconds);
            return new ExponentialApproach(fraction, ratePerSecond > 0 ? fraction / ratePerSecond : seconds, seconds);
        }

        /** Returns the value after the tick. */
        public double approach(double value, double target) {
            return target + (value - target) * (1 - fraction);
        }

        /** Returns the integral of the value over the tick. */
        public double displacement(double value, double target) {
            return target * seconds + (value - target) * displacementPerSpeed;
        }
    }
}
