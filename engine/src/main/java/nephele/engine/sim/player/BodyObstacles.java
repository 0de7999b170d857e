package nephele.engine.sim.player;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The bodies near the player as obstacles of its moves, at their poses at the start of the tick: bodies in the player's
 * space, and images of bodies in the spaces behind portals. The working set of one simulation.
 */
final class BodyObstacles {
    /** No held body. (A held body is no obstacle to the player.) */
    static final int NO_BODY = -1;

    /** A list entry is body × this, + 0 for the body itself or + 1 + i for its image that comes out of portal i. */
    private static final int IMAGES = PortalWorld.MOST_PORTALS + 1;

    private static final int NO_BODIES = Integer.MAX_VALUE;
    private static final double MARGIN_METRES = 0.05;
    private static final int POSE = 7;

    private final BodyTable table;
    private final Collider[] made;
    private final double[] poses;
    private final ItemList wanted = new ItemList();
    private final Vector3d centre = new Vector3d();
    private final Quaterniond orientation = new Quaterniond();
    private Bodies bodies = Bodies.NONE;
    private PortalWorld portalWorld;
    private int held = NO_BODY;
    private int[] joined = new int[0];
    private CollisionWorld solids;
    private CollisionWorld world;
    /** The index of the first body among the colliders of the last returned world. */
    private int firstBody = NO_BODIES;

    BodyObstacles(BodyTable table) {
        this.table = table;
        made = new Collider[table.size()];
        poses = new double[POSE * table.size()];
    }

    /** Starts a tick. */
    void enter(PortalWorld entered, Bodies now, int heldBody) {
        if (bodies != now || portalWorld != entered || held != heldBody) {
            bodies = now;
            portalWorld = entered;
            held = heldBody;
            solids = null;
        }
    }

    /** Returns the solids for an active-portal mask, with every body that the shape may hit on its path. */
    CollisionWorld around(long mask, RoundedHull shape, Vector3dc place, Vector3dc path) {
        CollisionWorld without = portalWorld.openedFor(mask);
        firstBody = NO_BODIES;
        if (bodies.size() == 0) {
            return without;
        }
        wanted.clear();
        for (int body = 0; body < bodies.size(); body++) {
            if (body != held) {
                want(body, mask, shape, place, path);
            }
        }
        if (wanted.size() == 0) {
            return without;
        }
        firstBody = without.size();
        return joined(without);
    }

    private void want(int body, long mask, RoundedHull shape, Vector3dc place, Vector3dc path) {
        bodies.centre(body, centre);
        if (isNear(body, shape, place, path) && !isBehindOpening(body, mask)) {
            wanted.accept(body * IMAGES);
        }
        Portals portals = portalWorld.portals();
        for (int i = 0; i < Math.min(portals.size(), PortalWorld.MOST_PORTALS); i++) {
            if (portals.isOpen(i)) {
                bodies.centre(body, centre);
                boolean sticksOut = table.mayReachThrough(body, centre, portals.portal(portals.partner(i)));
                if (sticksOut || isBefore(portals.portal(portals.partner(i))) && (mask & 1L << i) != 0) {
                    portals.transform(portals.partner(i)).point(centre);
                    if (isNear(body, shape, place, path)) {
                        wanted.accept(body * IMAGES + 1 + i);
                    }
                }
            }
        }
    }

    private boolean isBefore(Portal portal) {
        return portal.inFront(centre.x, centre.y, centre.z) >= 0;
    }

    /**
     * Returns true if a body stands behind a portal that is open for the player. There the aperture volume replaces
     * this space, so the player cannot hit the body.
     */
    private boolean isBehindOpening(int body, long mask) {
        for (int i = 0; i < Math.min(portalWorld.portals().size(), PortalWorld.MOST_PORTALS); i++) {
            Portal portal = (mask & 1L << i) != 0 ? portalWorld.portals().portal(i) : null;
            if (portal != null && !isBefore(portal) && table.mayReachBeside(body, centre, portal)) {
                return true;
            }
        }
        return false;
    }

    private boolean isNear(int body, RoundedHull shape, Vector3dc place, Vector3dc path) {
        double reach = table.reachMetres(body) + MARGIN_METRES;
        for (int axis = 0; axis < 3; axis++) {
            double from = place.get(axis);
            double to = from + path.get(axis);
            double at = centre.get(axis);
            if (at + reach < Math.min(from, to) + shape.least(axis)
                    || at - reach > Math.max(from, to) + shape.greatest(axis)) {
                return false;
            }
        }
        return true;
    }

    private CollisionWorld joined(CollisionWorld without) {
        if (solids == without && isJoined()) {
            return world;
        }
        joined = new int[wanted.size()];
        List<Collider> colliders = new ArrayList<>(joined.length);
        for (int i = 0; i < joined.length; i++) {
            joined[i] = wanted.get(i);
            colliders.add(collider(wanted.get(i)));
        }
        solids = without;
        world = without.with(colliders);
        return world;
    }

    private boolean isJoined() {
        if (joined.length != wanted.size()) {
            return false;
        }
        for (int i = 0; i < joined.length; i++) {
            if (joined[i] != wanted.get(i)) {
                return false;
            }
        }
        return true;
    }

    private Collider collider(int entry) {
        int body = entry / IMAGES;
        int through = entry % IMAGES - 1;
        bodies.centre(body, centre);
        bodies.orientation(body, orientation);
        if (through >= 0) {
            var transform =
                    portalWorld.portals().transform(portalWorld.portals().partner(through));
            transform.point(centre);
            return table.collider(body, centre, transform.orientation(orientation));
        }
        double[] pose = {centre.x, centre.y, centre.z, orientation.x, orientation.y, orientation.z, orientation.w};
        int at = POSE * body;
        if (made[body] == null || !Arrays.equals(pose, 0, POSE, poses, at, at + POSE)) {
            System.arraycopy(pose, 0, poses, at, POSE);
            made[body] = table.collider(body, centre, orientation);
        }
        return made[body];
    }

    /** Returns true if a collider of the last returned world is a body. */
    boolean isBody(int collider) {
        return collider >= firstBody;
    }

    /** Returns the velocity, in the player's space, of a body of the last returned world at {@code point}. */
    Vector3d velocity(int collider, Vector3dc point, Vector3d out) {
        int entry = joined[collider - firstBody];
        int body = entry / IMAGES;
        int through = entry % IMAGES - 1;
        Vector3d arm = new Vector3d(point);
        Portals portals = portalWorld.portals();
        if (through >= 0) {
            portals.transform(through).point(arm);
        }
        arm.sub(bodies.centre(body, centre));
        bodies.spin(body, out).cross(arm).add(bodies.velocity(body, centre));
        return through >= 0 ? portals.transform(portals.partner(through)).direction(out) : out;
    }
}
