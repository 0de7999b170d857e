package nephele.engine.collision.rigid;

import nephele.engine.collision.HullDistance;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Moves a shape along a straight line until it is {@link Sweep#SKIN_METRES} from the first body, as {@link Sweep} does
 * among solids: bodies in its own space, and those seen through portals that either of them is active on. Reused; the
 * accessors speak of the last cast.
 */
public final class BodyCast {
    private static final double TOUCH_METRES = 1e-8;
    private static final int MOST_STEPS = 64;
    private static final double SLIDING = 1e-9;

    private final BodyTable table;
    private final RoundedHull[] upright;
    private final RoundedHull[] turned;
    private final double[] reach;
    private final double[] axes = new double[9];
    private final HullDistance distance = new HullDistance();
    private final Vector3d centre = new Vector3d();
    private final Vector3d axis = new Vector3d();
    private final Vector3d point = new Vector3d();
    private final Vector3d normal = new Vector3d();
    private final Quaterniond orientation = new Quaterniond();
    private final ThroughPortals through = new ThroughPortals();

    private RoundedHull shape;
    private Vector3dc from;
    private Vector3dc way;
    private long active;
    private double fraction;
    private int body;
    private int portal;

    public BodyCast(BodyTable table) {
        this.table = table;
        upright = new RoundedHull[table.size()];
        turned = new RoundedHull[table.size()];
        reach = new double[table.size()];
        for (int i = 0; i < upright.length; i++) {
            upright[i] = table.uprightHull(i);
            turned[i] = upright[i].copy();
            Vec3 h = new Vec3(table.half(i, 0), table.half(i, 1), table.half(i, 2));
            reach[i] = table.kind(i) == BodyTable.BOX
                    ? Math.sqrt(h.x() * h.x() + h.y() * h.y() + h.z() * h.z())
                    : h.y() + h.z();
        }
    }

    /** How much of the displacement is free, 0 to 1. */
    public double fraction() {
        return fraction;
    }

    /** Of the surface that was hit, towards the shape; unit length. */
    public Vector3dc normal() {
        return normal;
    }

    /** The body that was hit, −1 for none. */
    public int body() {
        return body;
    }

    /** The portal through which the shape meets the body (the one the body is before), or {@link Portals#CLOSED}. */
    public int portal() {
        return portal;
    }

    /**
     * True when a body stands in the way. Bodies that the shape leaves or slides along do not, nor does {@code except}.
     *
     * @param activeMask of the shape, see {@link Surroundings#active}
     * @param except index of a body that the shape does not meet, or −1
     */
    public boolean cast(
            Bodies bodies,
            Portals portals,
            RoundedHull moving,
            long activeMask,
            Vector3dc start,
            Vector3dc motion,
            int except) {
        fraction = 1;
        body = -1;
        shape = moving;
        from = start;
        way = motion;
        active = activeMask;
        double length = motion.length();
        if (!(length > 0)) {
            return false;
        }
        for (int i = 0; i < bodies.size(); i++) {
            if (i != except) {
                against(bodies, portals, i, length);
            }
        }
        return body >= 0;
    }

    private void against(Bodies bodies, Portals portals, int i, double length) {
        long own = bodies.passages().active(i);
        meet(bodies, portals, i, Portals.CLOSED, length);
        long partners = 0;
        for (long left = active; left != 0; left &= left - 1) {
            partners |= 1L << portals.partner(Long.numberOfTrailingZeros(left));
        }
        for (long left = own | partners; left != 0; left &= left - 1) {
            int seen = Long.numberOfTrailingZeros(left);
            if (portals.passage(seen) != null) {
                meet(bodies, portals, i, seen, length);
            }
        }
    }

    /** One body as it is, or as it is seen through the portal that it is before. */
    private void meet(Bodies bodies, Portals portals, int i, int seen, double length) {
        Passage passage = seen == Portals.CLOSED ? null : portals.passage(seen);
        bodies.centre(i, centre);
        if (passage != null) {
            passage.point(centre);
        }
        double near = reach[i] + shape.reachMetres() + 2 * Sweep.SKIN_METRES + length;
        if (centre.distanceSquared(from) > near * near) {
            return;
        }
        turn(bodies, i, passage);
        double t = 0;
        for (int k = 0; k < MOST_STEPS; k++) {
            distance.measure(
                    shape,
                    from.x() + t * way.x() - centre.x,
                    from.y() + t * way.y() - centre.y,
                    from.z() + t * way.z() - centre.z,
                    turned[i]);
            double approach =
                    -(distance.normalX() * way.x() + distance.normalY() * way.y() + distance.normalZ() * way.z());
            double gap = distance.metres() - Sweep.SKIN_METRES;
            if (approach <= (gap <= TOUCH_METRES ? SLIDING * length : 0)) {
                return;
            }
            if (gap <= TOUCH_METRES || k == MOST_STEPS - 1) {
                keep(bodies, portals, i, seen, t);
                return;
            }
            t += gap / approach;
            if (!(t < fraction)) {
                return;
            }
        }
    }

    private void turn(Bodies bodies, int i, Passage passage) {
        bodies.orientation(i, orientation);
        for (int k = 0; k < 3; k++) {
            axis.set(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0);
            orientation.transform(axis);
            if (passage != null) {
                passage.direction(axis);
            }
            axes[3 * k] = axis.x;
            axes[3 * k + 1] = axis.y;
            axes[3 * k + 2] = axis.z;
        }
        turned[i].turn(upright[i], axes, 0);
    }

    /** A hit counts where both really are: both on this side of every portal, or both on the same other side. */
    private void keep(Bodies bodies, Portals portals, int i, int seen, double t) {
        nearestPoint(t);
        axis.set(from).fma(t, way);
        long ofShape = through.find(portals, active, axis, point);
        long own = bodies.passages().active(i);
        bodies.centre(i, axis);
        boolean valid;
        if (seen == Portals.CLOSED) {
            valid = ofShape == through.find(portals, own, axis, point);
        } else {
            portals.passage(portals.partner(seen)).point(point);
            long ofBody = through.find(portals, own, axis, point);
            long partner = 1L << portals.partner(seen);
            valid = (ofShape == 0 && ofBody == 1L << seen) || (ofShape == partner && ofBody == 0);
        }
        if (valid) {
            fraction = t;
            body = i;
            portal = seen;
            normal.set(distance.normalX(), distance.normalY(), distance.normalZ());
        }
    }

    /** Half-way between the surfaces where the shape reaches farthest towards the body. */
    private void nearestPoint(double t) {
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < shape.corePoints(); k++) {
            double along = shape.core(k, 0) * distance.normalX()
                    + shape.core(k, 1) * distance.normalY()
                    + shape.core(k, 2) * distance.normalZ();
            if (along < least) {
                least = along;
                best = k;
            }
        }
        double back = shape.radiusMetres() + Sweep.SKIN_METRES / 2;
        point.set(from)
                .fma(t, way)
                .add(shape.core(best, 0), shape.core(best, 1), shape.core(best, 2))
                .sub(back * distance.normalX(), back * distance.normalY(), back * distance.normalZ());
    }
}
