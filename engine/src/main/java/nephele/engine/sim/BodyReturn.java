package nephele.engine.sim;

import java.util.List;
import java.util.function.Function;
import nephele.engine.collision.Collider;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.sim.player.PlayerEye;
import nephele.engine.sim.player.PlayerMotion;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.PortalWorldCache;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Applies {@link Assist#BODY_RETURN}: a body that has fallen out of the world is put back at rest where the level has
 * it, as soon as that place is free. It keeps falling as long as the player or another body is in its place, also with
 * a part that reaches there through a portal. A held body stays with the player.
 */
final class BodyReturn {
    /** Bodies that rest on each other penetrate by less than this. */
    private static final double SUNK_METRES = 2e-3;

    private static final Vector3dc STILL = new Vector3d();

    private final BodyTable table;
    private final PortalWorldCache worlds;
    private final double lowest;
    private final Separation separation = new Separation();
    private final Vector3d centre = new Vector3d();

    /** @param lowest height below which nothing belongs to the world */
    BodyReturn(BodyTable table, PortalWorldCache worlds, double lowest) {
        this.table = table;
        this.worlds = worlds;
        this.lowest = lowest;
    }

    /** @param events receives an event for each body that returns */
    SimState after(SimState moved, List<TickEvent> events) {
        SimState state = moved;
        for (int body = 0; body < table.size(); body++) {
            if (isLost(state, body) && isFree(state, body)) {
                Bodies bodies = state.world().bodies();
                BodyState home = BodyState.resting(table.body(body).centre());
                state = state.with(state.world().with(bodies.with(body, home)));
                events.add(new TickEvent.BodyReturned(body));
            }
        }
        return state;
    }

    private boolean isLost(SimState state, int body) {
        Bodies bodies = state.world().bodies();
        return bodies.centre(body, centre).y < lowest
                && state.world().holding().body() != body
                && !bodies.isFrozen(body);
    }

    private boolean isFree(SimState state, int body) {
        Vector3d at = table.body(body).centre().toVector();
        Collider home = table.collider(body, at, new Quaterniond());
        PortalWorld world = worlds.of(state.world().portals());
        Place place = new Place(home, world, world.active(table.uprightHull(body), at, STILL));
        if (isIn(place, state.player())) {
            return false;
        }
        Bodies bodies = state.world().bodies();
        for (int other = 0; other < bodies.size(); other++) {
            if (other != body && isIn(place, bodies, other)) {
                return false;
            }
        }
        return true;
    }

    /**
     * A body's place in the level.
     *
     * @param active the portals into which the body would reach there
     */
    private record Place(Collider home, PortalWorld world, long active) {
        /** Returns true if something active on these portals may reach the place through a portal. */
        boolean isBeyond(int entry, long others) {
            Portals portals = world.portals();
            boolean hasBit = entry < PortalWorld.MOST_PORTALS && portals.partner(entry) < PortalWorld.MOST_PORTALS;
            return hasBit
                    && portals.isOpen(entry)
                    && (others & 1L << entry | active & 1L << portals.partner(entry)) != 0;
        }
    }

    private boolean isIn(Place place, PlayerState player) {
        Vec3 up = player.tilt().up();
        RoundedHull shape = PlayerMotion.shape(player.stance(), up);
        return isIn(place, PlayerEye.centre(player, new Vector3d()), shape, transform -> {
            Vec3 turned = Vec3.of(transform.direction(up.toVector()));
            return PlayerMotion.shape(player.stance(), turned);
        });
    }

    private boolean isIn(Place place, Bodies bodies, int other) {
        Quaterniond turn = bodies.orientation(other, new Quaterniond());
        RoundedHull shape = table.hull(other, turn);
        return isIn(place, bodies.centre(other, new Vector3d()), shape, transform -> {
            Quaterniond turned = transform.orientation(new Quaterniond(turn));
            return table.hull(other, turned);
        });
    }

    /**
     * Returns true if a shape is in the place, or reaches there through a portal.
     *
     * @param turned the shape as a portal's transform turns it
     */
    private boolean isIn(Place place, Vector3dc at, RoundedHull shape, Function<PortalTransform, RoundedHull> turned) {
        centre.set(at);
        if (isIn(place, shape)) {
            return true;
        }
        Portals portals = place.world.portals();
        long active = place.world.active(shape, at, STILL);
        for (int entry = 0; entry < portals.size(); entry++) {
            if (place.isBeyond(entry, active)) {
                PortalTransform transform = portals.transform(entry);
                transform.point(centre.set(at));
                if (isIn(place, turned.apply(transform))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Returns true if a shape at {@link #centre} is in the place. */
    private boolean isIn(Place place, RoundedHull shape) {
        separation.measure(shape, centre.x, centre.y, centre.z, place.home);
        return separation.metres() < -SUNK_METRES;
    }
}
