package nephele.engine.sim.player;

import static nephele.engine.sim.state.PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;

import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.Action;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.ViewAngles;
import nephele.engine.sim.state.WorldState;
import org.joml.Vector3d;

/**
 * Steps the player by one tick: look, stance, jump, walk or flight, through portals too. The working set of one
 * simulation.
 */
public final class PlayerStep {
    /** In m/s. A slower player without move intent stops, as the exponential would never end. */
    private static final double AT_REST_METRES_PER_SECOND = 1e-4;

    /** In metres. */
    private static final double HEAD_RADIUS_METRES = 0.1;

    private static final RoundedHull HEAD = RoundedHull.sphere(HEAD_RADIUS_METRES);

    private final double seconds;
    private final ExponentialApproach groundDamping;
    private final ExponentialApproach eyeDamping;
    private final CharacterMover mover;
    private final GroundWalk walk;
    private final PlayerPortalCrossing portalCrossing;
    private final AirFlight flight;
    /** {@code null} without the assist. */
    private final WalkIn walkIn;

    private final ExitRoom exitRoom = new ExitRoom();
    private final Depenetration depenetration = new Depenetration();
    private final Uprighting uprighting;
    private final PlayerMotion player = new PlayerMotion();
    private final MoveIntent intent = new MoveIntent();
    private final Vector3d way = new Vector3d();
    private final Vector3d head = new Vector3d();

    public PlayerStep(BodyTable bodies, SimSettings settings) {
        double seconds = 1.0 / settings.ticksPerSecond();
        this.seconds = seconds;
        mover = new CharacterMover(new BodyObstacles(bodies));
        walk = new GroundWalk(mover);
        portalCrossing = new PlayerPortalCrossing(mover);
        flight = new AirFlight(mover, walk, portalCrossing);
        walkIn = settings.assists().contains(Assist.WALK_IN) ? new WalkIn() : null;
        groundDamping = ExponentialApproach.of(PlayerDimensions.GROUND_RATE_PER_SECOND, seconds);
        eyeDamping = ExponentialApproach.of(PlayerDimensions.EYE_RATE_PER_SECOND, seconds);
        uprighting = new Uprighting(mover, depenetration, settings);
    }

    /** @param around the world state; its bodies are obstacles, except the one that does not collide with the player */
    public PlayerState step(PortalWorld world, WorldState around, PlayerState before, PlayerInput input) {
        boolean isEmpty = world.statics().size() == 0;
        ViewAngles heading = before.heading().turned(input.turnLeftMillidegrees(), input.turnUpMillidegrees());
        load(before, heading, isEmpty);
        mover.enter(world, around.bodies(), around.holding().passing());
        portalCrossing.begin(world.portals(), player.place);
        changeStance(input.holds(Action.CROUCH));
        if (recover()) {
            uprighting.turn(player);
            portalCrossing.follow(player);
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
        portalCrossing.follow(player);
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
        return portalCrossing.word();
    }

    /** Returns true if the last tick had more crossings than allowed and ended at the last allowed one. */
    public boolean hasDroppedTime() {
        return portalCrossing.hasDropped();
    }

    private void load(PlayerState before, ViewAngles heading, boolean isEmpty) {
        player.load(before);
        player.look(new PlayerView(heading, before.tilt()));
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
        var up = player.look().tilt().up();
        way.set(up.x() * rise, up.y() * rise, up.z() * rise);
        if (wantsCrouch || !mover.isBlocked(player.shape(), player.place, way)) {
            player.change(wanted);
        }
    }

    /** Pushes the player out of solids, a little each tick. Returns false while it is still inside. */
    private boolean recover() {
        RoundedHull shape = player.shape();
        depenetration.find(mover.world(shape, player.place), shape, player.place, way);
        double needed = way.length();
        if (needed == 0) {
            return true;
        }
        double pushed = Math.min(needed, PlayerDimensions.DEPENETRATION_METRES_PER_TICK);
        player.place.add(way.mul(pushed / needed));
        if (pushed < needed) {
            player.velocity.zero();
            player.grounded = false;
            return false;
        }
        return true;
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
        intent.of(player, input);
        RoundedHull shape = player.shape();
        exitRoom.easing(player, intent, exit, mover.world(shape, player.place)).mul(seconds, way);
        if (way.lengthSquared() == 0) {
            return;
        }
        if (!player.grounded) {
            mover.slide(shape, player.place, way);
            return;
        }
        head.set(player.place);
        boolean stands = walk.walk(shape, player.place, way, player.ground);
        way.set(0, -player.stance().heightMetres() / 2 - PlayerDimensions.STEP_METRES / 2, 0);
        if (stands && mover.isBlocked(HEAD, player.place, way)) {
            player.ground.set(walk.ground());
        } else {
            player.place.set(head);
        }
    }

    /** Sets the vertical speed for a ballistic apex of exactly the jump height. */
    private void jump() {
        player.velocity.y = Math.sqrt(2 * GRAVITY_METRES_PER_SECOND_SQUARED * PlayerDimensions.JUMP_METRES);
        player.grounded = false;
    }

    private void walkOnGround(PlayerInput input, Portals portals) {
        intent.of(player, input);
        boolean isLed = walkIn != null && walkIn.lead(player, intent, portals, seconds);
        Vector3d velocity = player.velocity;
        way.set(
                groundDamping.displacement(velocity.x, intent.x()),
                0,
                groundDamping.displacement(velocity.z, intent.z()));
        velocity.set(groundDamping.approach(velocity.x, intent.x()), 0, groundDamping.approach(velocity.z, intent.z()));
        if (intent.velocity().lengthSquared() == 0 && velocity.length() < AT_REST_METRES_PER_SECOND) {
            velocity.zero();
            way.zero();
        }
        mover.pushes().intent(velocity);
        double height = player.place.y;
        double slope = -(player.ground.x * way.x + player.ground.z * way.z) / player.ground.y;
        player.grounded = isLed
                ? walk.walkOverFrames(player.shape(), player.place, way, player.ground)
                : walk.walk(player.shape(), player.place, way, player.ground);
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
            way.set(0, player.eye - inHead, 0);
            double headAboveCentre = inHead - player.stance().centreAboveFeet();
            head.set(player.place.x, player.place.y + headAboveCentre, player.place.z);
            mover.isBlocked(HEAD, head, way);
            player.eye = inHead + mover.lastSweep().fraction() * way.y;
        }
    }
}
