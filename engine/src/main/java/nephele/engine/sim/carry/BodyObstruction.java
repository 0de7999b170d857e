package nephele.engine.sim.carry;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyRay;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.MovingSurfaces;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The bodies as obstacles of a line of sight or a shot, including the parts of bodies that stick out of portals. */
final class BodyObstruction implements Obstacles, MovingSurfaces {
    static final int NOTHING = -1;

    private final BodyTable table;
    private final BodyRay ray;
    private final Vector3d centre = new Vector3d();
    private final Vector3d mappedFrom = new Vector3d();
    private final Vector3d mappedWay = new Vector3d();
    private Bodies bodies = Bodies.NONE;
    private Portals portals = Portals.NONE;
    private double nearest;
    private int met = NOTHING;
    private int through = Portals.CLOSED;

    BodyObstruction(BodyTable table) {
        this.table = table;
        ray = new BodyRay(table);
    }

    BodyObstruction at(Bodies now, Portals open) {
        bodies = now;
        portals = open;
        return this;
    }

    /** Returns the body that stopped the last line, or {@link #NOTHING}. */
    int met() {
        return met;
    }

    /**
     * Returns the portal through which the centre of the hit body is reached, {@link Portals#CLOSED} if it is in the
     * same space as the hit.
     */
    int through() {
        return through;
    }

    @Override
    public double free(Vector3dc from, Vector3dc way) {
        return free(from, way, 1);
    }

    /** Does the same for a line that something else ends at the fraction {@code most} of the way. */
    double free(Vector3dc from, Vector3dc way, double most) {
        nearest = most;
        met = NOTHING;
        through = Portals.CLOSED;
        for (int body = 0; body < bodies.size(); body++) {
            offer(body, Portals.CLOSED, ray.distance(bodies, body, from, way));
        }
        for (int exit = 0; bodies.size() > 0 && exit < portals.size(); exit++) {
            if (portals.isOpen(exit)) {
                meetWhatSticksOutOf(exit, from, way);
            }
        }
        return nearest;
    }

    @Override
    public double distance(Vec3 eye, Vec3 direction, double limitMetres) {
        double share = free(eye.toVector(), direction.toVector().mul(limitMetres));
        return share < 1 ? share * limitMetres : Double.POSITIVE_INFINITY;
    }

    private void meetWhatSticksOutOf(int exit, Vector3dc from, Vector3dc way) {
        Portal entry = portals.portal(portals.partner(exit));
        PortalTransform back = portals.transform(exit);
        boolean isMapped = false;
        for (int body = 0; body < bodies.size(); body++) {
            if (!table.mayReachThrough(body, bodies.centre(body, centre), entry)) {
                continue;
            }
            if (!isMapped) {
                back.point(mappedFrom.set(from));
                back.direction(mappedWay.set(way));
                isMapped = true;
            }
            double t = ray.distance(bodies, body, mappedFrom, mappedWay);
            mappedFrom.fma(t, mappedWay, centre);
            if (t < nearest && entry.inFront(centre.x, centre.y, centre.z) <= 0) {
                offer(body, exit, t);
            }
        }
    }

    private void offer(int body, int exit, double share) {
        if (share < nearest) {
            nearest = share;
            met = body;
            through = exit;
        }
    }
}
