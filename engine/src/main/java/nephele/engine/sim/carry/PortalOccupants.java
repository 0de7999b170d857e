package nephele.engine.sim.carry;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Moves the player and the bodies out of a portal that is moved or closed; the side of the centre decides where each
 * belongs. One without room is swept out along the old portal's normal, or depenetrated by a short push. If neither
 * leads to a free place, the portal stays.
 */
public final class PortalOccupants {
    /** Resting bodies penetrate their support by less than this. */
    public static final double SUNK_METRES = 2e-3;

    private final BodyTable table;
    private final Depenetration depenetration = new Depenetration();
    private final Sweep sweep = new Sweep();
    private final Vector3d centre = new Vector3d();
    private final Vector3d push = new Vector3d();
    private PortalWorld before;
    private PortalWorld after;

    public PortalOccupants(BodyTable table) {
        this.table = table;
    }

    /**
     * Returns the state with the player and all bodies in free places of the new space; {@code null} if one finds none.
     */
    public SimState settle(SimState state, PortalWorld from, PortalWorld to) {
        before = from;
        after = to;
        PlayerState player = player(state.player());
        Bodies bodies = player == null ? null : bodies(state.world().bodies());
        return bodies == null
                ? null
                : state.withPlayer(player).with(state.world().with(bodies));
    }

    private PlayerState player(PlayerState player) {
        player.centre(centre);
        if (!findPush(player.stance().shape(player.tilt().up()))) {
            return null;
        }
        Vec3 feet = player.feet();
        return isPushed() ? player.withFeet(new Vec3(feet.x() + push.x, feet.y() + push.y, feet.z() + push.z)) : player;
    }

    private Bodies bodies(Bodies bodies) {
        Bodies settled = bodies;
        var orientation = new Quaterniond();
        for (int i = 0; i < bodies.size(); i++) {
            bodies.centre(i, centre);
            if (!findPush(table.hull(i, bodies.orientation(i, orientation)))) {
                return null;
            }
            if (isPushed()) {
                BodyState state = bodies.state(i);
                Vec3 place = Vec3.of(centre.add(push));
                settled = settled.with(i, new BodyState(place, state.orientation(), state.velocity(), state.spin()));
            }
        }
        return settled;
    }

    private boolean isPushed() {
        return push.lengthSquared() > 0;
    }

    /** Finds the push for a shape at {@code centre}. Returns false if there is none. */
    private boolean findPush(RoundedHull shape) {
        push.zero();
        long was = before.active(shape, centre);
        if (was == 0 && after.active(shape, centre) == 0 || isFree(shape)) {
            return true;
        }
        for (int i = 0; i < before.portals().size(); i++) {
            if ((was & 1L << i) != 0 && outOf(before.portals().portal(i), shape)) {
                return true;
            }
        }
        if (depenetration.find(world(shape), shape, centre, push) && arrives(shape)) {
            return true;
        }
        push.zero();
        // A shape that was in a solid before and is no deeper in one now is no reason to refuse.
        double depth = depenetration.depth(before.openedFor(was), shape, centre);
        return depth > SUNK_METRES && depenetration.depth(world(shape), shape, centre) <= depth;
    }

    private CollisionWorld world(RoundedHull shape) {
        return after.openedFor(after.active(shape, centre, push));
    }

    private boolean isFree(RoundedHull shape) {
        return depenetration.depth(world(shape), shape, centre) <= SUNK_METRES;
    }

    /** Sets the push that brings the whole shape before a portal's plane. Returns true if it leads to a free place. */
    private boolean outOf(Portal portal, RoundedHull shape) {
        Vec3 n = portal.normal();
        double behind = 0;
        for (int i = 0; i < shape.corePoints(); i++) {
            double along = n.x() * shape.core(i, 0) + n.y() * shape.core(i, 1) + n.z() * shape.core(i, 2);
            behind = Math.max(behind, shape.radiusMetres() - along);
        }
        double metres = behind + Sweep.SKIN_METRES - portal.inFront(centre.x, centre.y, centre.z);
        push.set(n.x(), n.y(), n.z()).mul(Math.max(0, metres));
        return arrives(shape);
    }

    /** Returns true if the push is unobstructed and its end free; otherwise resets the push to zero. */
    private boolean arrives(RoundedHull shape) {
        boolean blocked = sweep.cast(world(shape), shape, centre, push);
        centre.add(push);
        boolean free = !blocked && isFree(shape);
        centre.sub(push);
        if (!free) {
            push.zero();
        }
        return free;
    }
}
