package nephele.engine.sim.carry;

import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.PathTrace.End;
import nephele.engine.portal.Portals;
import nephele.engine.sim.player.PlayerEye;
import nephele.engine.sim.player.PlayerMotion;
import nephele.engine.sim.state.HeldBody;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Picks bodies up and keeps track of the line to the held one. The hands reach along the line of sight, through
 * portals; the crossing word of the line is updated when the player or the body goes through a portal.
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

    private final BodyTable table;
    private final BodyObstruction bodies;
    private final Separation separation = new Separation();
    private final int graceTicks;
    private final Vector3d point = new Vector3d();

    CarryRules(BodyTable table, BodyObstruction bodies, double secondsPerTick) {
        this.table = table;
        this.bodies = bodies;
        graceTicks = (int) Math.ceil(GRACE_SECONDS / secondsPerTick);
    }

    /** Returns what the player would hold if it picked up now. */
    HeldBody reach(SimState state, PortalWorld space) {
        Portals portals = space.portals();
        bodies.at(state.world().bodies(), portals);
        var sight = new LineOfSight(portals, (from, way) -> bodies.free(from, way, space.free(from, way)));
        PlayerEye.direction(PlayerEye.view(state.player()), point).mul(REACH_METRES);
        End end = sight.look(state.player(), point.add(PlayerEye.eye(state.player(), new Vector3d())));
        if (end != End.BLOCKED || bodies.met() == BodyObstruction.NOTHING) {
            return HeldBody.NOTHING;
        }
        CrossingWord word = sight.word();
        boolean sticksOut = bodies.through() != Portals.CLOSED;
        return new HeldBody(bodies.met(), sticksOut ? word.then(bodies.through(), portals) : word, 0);
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
        if (!held.isHolding() || isSeen(held, player, now, space)) {
            return held.unseenFor(0);
        }
        return held.ticksUnseen() < graceTicks ? held.unseenFor(held.ticksUnseen() + 1) : held.released();
    }

    /**
     * Returns true if the straight line to the body's centre crosses exactly the portals of the crossing word and no
     * solid.
     */
    private static boolean isSeen(HeldBody held, PlayerState player, Bodies now, PortalWorld space) {
        if (!held.isOpen(space.portals())) {
            return false;
        }
        Vector3dc there = held.pointHere(now.centre(held.body(), new Vector3d()), space.portals());
        var sight = new LineOfSight(space.portals(), space::free);
        return sight.look(player, there) == End.ARRIVED && sight.word().equals(held.word());
    }

    /** Returns true if a dropped body still overlaps the player. */
    boolean isWithin(PlayerState player, Bodies now, int body) {
        var solid = table.collider(body, now.centre(body, new Vector3d()), now.orientation(body, new Quaterniond()));
        PlayerEye.centre(player, point);
        separation.measure(PlayerMotion.shape(player.stance(), player.tilt().up()), point.x, point.y, point.z, solid);
        return separation.metres() < APART_METRES;
    }
}
