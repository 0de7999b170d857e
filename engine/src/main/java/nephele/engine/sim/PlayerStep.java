package nephele.engine.sim;

import static nephele.engine.sim.PlayerBody.GRAVITY;

import nephele.engine.collision.Recovery;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.portal.CrossingWord;
import nephele.engine.sim.PlayerBody.Stance;
import org.joml.Vector3d;

/**
 * Steps the player by one tick: look, stance, jump, walk or flight, through portals too. The working set of one
 * simulation.
 */
final class PlayerStep {
    /** In m/s. A slower player without move intent stops, as the exponential would never end. */
    private static final double AT_REST_SPEED = 1e-4;

    /** In metres. */
    private static final double HEAD_RADIUS = 0.1;

    private static final RoundedHull HEAD = RoundedHull.sphere(HEAD_RADIUS);

    private final double seconds;
    private final Damping groundDamping;
    private final Damping eyeDamping;
    private final Mover mover;
    private final GroundWalk walk;
    private final Passing passing;
    private final AirFlight flight;
    private final Recovery recovery = new Recovery();
    private final Uprighting uprighting;
    private final PlayerMotion player = new PlayerMotion();
    private final Wish wish = new Wish();
    private final Vector3d way = new Vector3d();
    private final Vector3d head = new Vector3d();

    PlayerStep(BodyTable bodies, SimSettings settings) {
        double seconds = 1.0 / settings.ticksPerSecond();
        this.seconds = seconds;
        mover = new Mover(new BodyObstacles(bodies));
        walk = new GroundWalk(mover);
        passing = new Passing(mover);
        flight = new AirFlight(mover, walk, passing);
        groundDamping = Damping.of(PlayerBody.GROUND_RATE_PER_SECOND, seconds);
        eyeDamping = Damping.of(PlayerBody.EYE_RATE_PER_SECOND, seconds);
        uprighting = new Uprighting(mover, recovery, settings);
    }

    /** @param around the world state; its bodies are obstacles, except the one that does not collide with the player */
    PlayerState step(SeamedWorld world, Changeable around, PlayerState before, PlayerInput input) {
        boolean isEmpty = world.statics().size() == 0;
        Heading heading = before.heading().turned(input.turnLeftMillidegrees(), input.turnUpMillidegrees());
        load(before, heading, isEmpty);
        mover.enter(world, around.bodies(), around.holding().passing());
        passing.begin(world.portals(), player.place);
        changeStance(input.holds(Action.CROUCH));
        if (recover()) {
            uprighting.turn(player);
            passing.follow(player);
            settle();
            if (player.grounded && !isEmpty && input.holds(Action.JUMP) && !before.jumpHeld()) {
                jump();
            }
            if (player.grounded) {
                walkOnGround(input);
            } else {
                flight.fly(player, input, seconds);
            }
        }
        passing.follow(player);
        mover.shoves().settle(player, seconds);
        player.eye = eyeDamping.approach(player.eye, player.stance().eyeMetres());
        return player.store(input.holds(Action.JUMP));
    }

    /** Returns the player's contacts with bodies in the last tick. */
    Shoves shoves() {
        return mover.shoves();
    }

    /** Returns the crossing word of the last tick. */
    CrossingWord crossed() {
        return passing.word();
    }

    /** Returns true if the last tick had more crossings than allowed and ended at the last allowed one. */
    boolean hasDroppedTime() {
        return passing.hasDropped();
    }

    private void load(PlayerState before, Heading heading, boolean isEmpty) {
        player.load(before);
        player.look(new Look(heading, before.tilt()));
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
        recovery.find(mover.world(shape, player.place), shape, player.place, way);
        double needed = way.length();
        if (needed == 0) {
            return true;
        }
        double pushed = Math.min(needed, PlayerBody.RECOVERY_METRES_PER_TICK);
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

    /** Sets the vertical speed for a ballistic apex of exactly the jump height. */
    private void jump() {
        player.velocity.y = Math.sqrt(2 * GRAVITY * PlayerBody.JUMP_HEIGHT);
        player.grounded = false;
    }

    private void walkOnGround(PlayerInput input) {
        wish.of(player, input);
        Vector3d velocity = player.velocity;
        way.set(groundDamping.way(velocity.x, wish.x()), 0, groundDamping.way(velocity.z, wish.z()));
        velocity.set(groundDamping.approach(velocity.x, wish.x()), 0, groundDamping.approach(velocity.z, wish.z()));
        if (wish.velocity().lengthSquared() == 0 && velocity.length() < AT_REST_SPEED) {
            velocity.zero();
            way.zero();
        }
        mover.shoves().wish(velocity);
        double height = player.place.y;
        double slope = -(player.ground.x * way.x + player.ground.z * way.z) / player.ground.y;
        player.grounded = walk.walk(player.shape(), player.place, way, player.ground);
        player.ground.set(walk.ground());
        walk.walls().clip(velocity);
        smoothEye(player.place.y - height - slope);
    }

    /**
     * Lets the eye lag when the feet step up or down. It stays within the body or, on the way down, in free air above
     * it.
     */
    private void smoothEye(double suddenRise) {
        player.eye = Math.max(PlayerBody.RADIUS, player.eye - suddenRise);
        double inHead = player.stance().heightMetres() - HEAD_RADIUS;
        if (player.eye > inHead) {
            way.set(0, player.eye - inHead, 0);
            double headAboveCentre = inHead - player.stance().centreAboveFeet();
            head.set(player.place.x, player.place.y + headAboveCentre, player.place.z);
            mover.isBlocked(HEAD, head, way);
            player.eye = inHead + mover.lastSweep().fraction() * way.y;
        }
    }
}
