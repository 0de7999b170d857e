package nephele.engine.sim.carry;

import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.PathTrace.End;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState.HeldBody;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Picks bodies up, drives the held one, throws it, and keeps track of the line to it. The hands reach along the line of
 * sight, through portals; the crossing word of the line is updated when the player or the body goes through a portal.
 *
 * <p>A held body is driven to a place before the eye by a velocity that brings it there without overshooting, within the
 * limits of force, acceleration and speed. It follows the player's own motion.
 */
public final class CarryRules {
    /** The greatest distance from the eye to a body's surface. */
    static final double REACH_METRES = 2.5;
    /**
     * A held body is dropped after its line was broken for this long, so that a short occlusion by a door frame does
     * not drop it.
     */
    public static final double GRACE_SECONDS = 0.5;

    /** A body nearer than this to the player's capsule overlaps it. */
    private static final double APART_METRES = 0.01;

    /** The gap between the player's capsule and the held body's bounding sphere. */
    private static final double GAP_METRES = 0.35;

    private static final double DRIVE_RATE_PER_SECOND = 15;
    /** The greatest speed relative to the player, m/s. */
    private static final double DRIVE_METRES_PER_SECOND = 8;

    private static final double MAX_NEWTONS = 1500;
    /** The greatest acceleration, m/s²: by {@link #MAX_NEWTONS} alone, light bodies would jump. */
    private static final double MAX_METRES_PER_SECOND_SQUARED = 120;

    /** The greatest spin of a held body, rad/s. */
    private static final double MAX_RADIANS_PER_SECOND = 12;
    /** The speed of a throw, m/s; that of heavy bodies follows from {@link #THROW_NEWTON_SECONDS}. */
    private static final double THROW_METRES_PER_SECOND = 8;

    private static final double THROW_NEWTON_SECONDS = 160;

    private final BodyTable table;
    private final BodyObstruction bodies;
    private final Separation separation = new Separation();
    private final double seconds;
    private final int graceTicks;
    private final Vector3d point = new Vector3d();
    private final Vector3d target = new Vector3d();
    private final Vector3d eye = new Vector3d();
    private final Vector3d ahead = new Vector3d();
    private final Vector3d carried = new Vector3d();

    CarryRules(BodyTable table, BodyObstruction bodies, double secondsPerTick) {
        this.table = table;
        this.bodies = bodies;
        seconds = secondsPerTick;
        graceTicks = (int) Math.ceil(GRACE_SECONDS / secondsPerTick);
    }

    /** Returns what the player would hold if it picked up now. */
    HeldBody reach(SimState state, PortalWorld space) {
        Portals portals = space.portals();
        bodies.at(state.world().bodies(), portals);
        PlayerState player = state.player();
        player.ahead(point).mul(REACH_METRES).add(player.eye(new Vector3d()));
        PathTrace toEye = player.pathToEye(portals);
        Obstacles obstacles = (from, path) -> bodies.free(from, path, space.free(from, path));
        PathTrace sight = lineOfSight(player, toEye, point, portals, obstacles);
        if (sight.end() != End.BLOCKED || bodies.met() == BodyObstruction.NOTHING) {
            return HeldBody.NOTHING;
        }
        CrossingWord word = sight.wordAfter(toEye.word());
        boolean sticksOut = bodies.through() != Portals.CLOSED;
        return new HeldBody(bodies.met(), sticksOut ? word.then(bodies.through(), portals) : word, 0);
    }

    /**
     * Returns the line of sight from a player's eye, straight on through portals up to an obstacle.
     *
     * @param toEye the path from the player's centre to the eye
     * @param towards the end of the line, in the space of the player's centre, as if there were no portals in between
     */
    private static PathTrace lineOfSight(
            PlayerState player, PathTrace toEye, Vector3dc towards, Portals portals, Obstacles obstacles) {
        Vector3d line = new Vector3d(towards).sub(player.eye(new Vector3d()));
        var sight = new PathTrace(portals, obstacles);
        sight.trace(toEye.place(), toEye.carryDirection(line));
        return sight;
    }

    /**
     * Returns the holding with the crossing word after a tick in which player and body may have gone through portals.
     */
    static HeldBody follow(HeldBody held, CrossingWord player, Bodies bodies, Portals portals) {
        if (!held.isHolding()) {
            return held;
        }
        CrossingWord word = held.word();
        for (int i = 0; i < player.length(); i++) {
            word = word.afterEntering(player.entry(i), portals);
        }
        for (int i = 0; i < bodies.crossings(held.body()); i++) {
            word = word.then(bodies.crossing(held.body(), i), portals);
        }
        return new HeldBody(held.body(), word, held.ticksUnseen());
    }

    /** Returns the holding, or a released one if its line has been broken for too long. */
    HeldBody keepInSight(HeldBody held, PlayerState player, Bodies now, PortalWorld space) {
        if (!held.isHolding() || isInSight(held, player, now, space)) {
            return held.unseenFor(0);
        }
        return held.ticksUnseen() < graceTicks ? held.unseenFor(held.ticksUnseen() + 1) : held.released();
    }

    /**
     * Returns true if the straight line to the body's centre crosses exactly the portals of the crossing word and no
     * solid.
     */
    private static boolean isInSight(HeldBody held, PlayerState player, Bodies now, PortalWorld space) {
        Portals portals = space.portals();
        if (!held.isOpen(portals)) {
            return false;
        }
        Vector3dc there = held.pointHere(now.centre(held.body(), new Vector3d()), portals);
        PathTrace toEye = player.pathToEye(portals);
        PathTrace sight = lineOfSight(player, toEye, there, portals, space::free);
        return sight.end() == End.ARRIVED && sight.wordAfter(toEye.word()).equals(held.word());
    }

    /** Returns true if a dropped body still overlaps the player. */
    boolean isWithin(PlayerState player, Bodies now, int body) {
        var solid = table.collider(body, now.centre(body, new Vector3d()), now.orientation(body, new Quaterniond()));
        player.centre(point);
        separation.measure(player.stance().shape(player.tilt().up()), point.x, point.y, point.z, solid);
        return separation.metres() < APART_METRES;
    }

    /** Returns the motion with which a held body starts this tick. */
    BodyState motion(SimState state, PlayerInput input, PortalWorld space) {
        HeldBody held = state.world().holding();
        Portals portals = space.portals();
        BodyState body = state.world().bodies().state(held.body());
        PlayerState player = state.player();
        held.pointThere(place(held, player, space), portals).sub(body.centre().toVector());
        Vec3 own = player.velocity();
        held.directionThere(carried.set(own.x(), own.y(), own.z()), portals);
        Vector3d velocity = approach(target, acceleration(held.body())).add(carried);
        limitChange(velocity, body.velocity().toVector(), acceleration(held.body()) * seconds);
        return body.moving(Vec3.of(velocity), spin(held, input, portals));
    }

    private double acceleration(int body) {
        return Math.min(MAX_METRES_PER_SECOND_SQUARED, MAX_NEWTONS / table.massKilograms(body));
    }

    /** Returns the target of the body's centre in the player's space, as if there were no portals. */
    private Vector3d place(HeldBody held, PlayerState player, PortalWorld space) {
        double reach = table.reachMetres(held.body());
        player.eye(eye);
        player.ahead(ahead);
        double metres = PlayerDimensions.RADIUS_METRES + GAP_METRES + reach;
        target.set(eye).fma(metres + reach, ahead);
        Portals portals = space.portals();
        PathTrace sight = lineOfSight(player, player.pathToEye(portals), target, portals, space::free);
        double freeMetres = target.sub(eye).length() * sight.freeFraction();
        double free = Math.max(0, Math.min(metres, freeMetres - reach / 2));
        return target.set(eye).fma(free, ahead);
    }

    /** Scales a displacement to a velocity towards its end, limited so that the body can stop there. */
    private Vector3d approach(Vector3d displacement, double acceleration) {
        double metres = displacement.length();
        if (metres == 0) {
            return displacement;
        }
        double stopping = 0.7 * Math.sqrt(2 * acceleration * metres);
        double speed = Math.min(
                DRIVE_METRES_PER_SECOND,
                Math.min(stopping, metres * -StrictMath.expm1(-DRIVE_RATE_PER_SECOND * seconds) / seconds));
        return displacement.mul(speed / metres);
    }

    private static void limitChange(Vector3d velocity, Vector3d before, double most) {
        velocity.sub(before);
        double change = velocity.length();
        velocity.mul(change > most ? most / change : 1).add(before);
    }

    /** Returns the spin that turns the held body with the player's yaw. */
    private Vec3 spin(HeldBody held, PlayerInput input, Portals portals) {
        double yaw = Math.toRadians(input.turnLeftMillidegrees() / 1000.0) / seconds;
        double limited = Math.max(-MAX_RADIANS_PER_SECOND, Math.min(MAX_RADIANS_PER_SECOND, yaw));
        return Vec3.of(held.directionThere(carried.set(0, limited, 0), portals));
    }

    /** Returns the motion of a body that is thrown along the view. */
    BodyState thrown(SimState state, Portals portals) {
        HeldBody held = state.world().holding();
        BodyState body = state.world().bodies().state(held.body());
        double speed = Math.min(THROW_METRES_PER_SECOND, THROW_NEWTON_SECONDS / table.massKilograms(held.body()));
        Vec3 own = state.player().velocity();
        state.player().ahead(ahead).mul(speed).add(own.x(), own.y(), own.z());
        return body.moving(Vec3.of(held.directionThere(ahead, portals)), body.spin());
    }
}
