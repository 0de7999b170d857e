package nephele.engine.sim.carry;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The bodies as obstacles of a line of sight or a shot, including the parts of bodies that stick out of portals. */
final class BodyObstruction implements Obstacles {
    static final int NOTHING = -1;

    private final BodyTable table;
    private final Vector3d centre = new Vector3d();
    private final Vector3d mappedFrom = new Vector3d();
    private final Vector3d mappedPath = new Vector3d();
    /** The ray in the axes of a body. */
    private final Vector3d origin = new Vector3d();

    private final Vector3d direction = new Vector3d();
    private final Vector3d bodyCentre = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private Bodies bodies = Bodies.NONE;
    private Portals portals = Portals.NONE;
    private double nearest;
    private int met = NOTHING;
    private int through = Portals.CLOSED;

    BodyObstruction(BodyTable table) {
        this.table = table;
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
    public double free(Vector3dc from, Vector3dc path) {
        return free(from, path, 1);
    }

    /** Returns the part of a path before the first body, at most {@code most}, at which something else ends the line. */
    double free(Vector3dc from, Vector3dc path, double most) {
        nearest = most;
        met = NOTHING;
        through = Portals.CLOSED;
        for (int body = 0; body < bodies.size(); body++) {
            offer(body, Portals.CLOSED, entry(body, from, path));
        }
        for (int exit = 0; bodies.size() > 0 && exit < portals.size(); exit++) {
            if (portals.isOpen(exit)) {
                meetWhatSticksOutOf(exit, from, path);
            }
        }
        return nearest;
    }

    private void meetWhatSticksOutOf(int exit, Vector3dc from, Vector3dc path) {
        Portal entry = portals.portal(portals.partner(exit));
        PortalTransform back = portals.transform(exit);
        boolean isMapped = false;
        for (int body = 0; body < bodies.size(); body++) {
            if (!table.mayReachThrough(body, bodies.centre(body, centre), entry)) {
                continue;
            }
            if (!isMapped) {
                back.point(mappedFrom.set(from));
                back.direction(mappedPath.set(path));
                isMapped = true;
            }
            double t = entry(body, mappedFrom, mappedPath);
            mappedFrom.fma(t, mappedPath, centre);
            if (t < nearest && entry.inFront(centre.x, centre.y, centre.z) <= 0) {
                offer(body, exit, t);
            }
        }
    }

    private void offer(int body, int exit, double fraction) {
        if (fraction < nearest) {
            nearest = fraction;
            met = body;
            through = exit;
        }
    }

    /**
     * Returns the ray parameter at which the body is entered, 0 for a ray that starts in it, infinity for a miss:
     * metres for a direction of unit length.
     */
    private double entry(int body, Vector3dc from, Vector3dc path) {
        bodies.orientation(body, turn);
        bodies.centre(body, bodyCentre);
        turn.transformInverse(from.sub(bodyCentre, origin));
        turn.transformInverse(path, direction);
        return switch (table.kind(body)) {
            case BodyTable.SPHERE -> ball(0, table.half(body, 2));
            case BodyTable.CAPSULE -> capsule(table.half(body, 1), table.half(body, 2));
            default -> box(body);
        };
    }

    /** Intersects the slabs of three pairs of planes (Kay and Kajiya 1986). */
    private double box(int body) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double half = table.half(body, axis);
            double rate = direction.get(axis);
            double at = origin.get(axis);
            if (rate == 0) {
                leave = Math.abs(at) > half ? Double.NEGATIVE_INFINITY : leave;
            } else {
                enter = Math.max(enter, (-Math.copySign(half, rate) - at) / rate);
                leave = Math.min(leave, (Math.copySign(half, rate) - at) / rate);
            }
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    /** Intersects a sphere with its centre {@code height} above the body's. */
    private double ball(double height, double radius) {
        double y = origin.y - height;
        double offset = origin.x * origin.x + y * y + origin.z * origin.z - radius * radius;
        double along = origin.x * direction.x + y * direction.y + origin.z * direction.z;
        return entry(direction.lengthSquared(), along, offset);
    }

    /** Intersects two spheres and the tube between them. */
    private double capsule(double halfAxis, double radius) {
        double square = direction.x * direction.x + direction.z * direction.z;
        double along = origin.x * direction.x + origin.z * direction.z;
        double offset = origin.x * origin.x + origin.z * origin.z - radius * radius;
        double tube = square > 0 ? entry(square, along, offset) : offset <= 0 ? 0 : Double.POSITIVE_INFINITY;
        boolean between = Math.abs(origin.y + tube * direction.y) <= halfAxis;
        return Math.min(
                between ? tube : Double.POSITIVE_INFINITY, Math.min(ball(-halfAxis, radius), ball(halfAxis, radius)));
    }

    /** Returns the first t ≥ 0 with square t² + 2 along t + offset ≤ 0, infinity for none. */
    private static double entry(double square, double along, double offset) {
        if (offset <= 0) {
            return 0;
        }
        double root = Math.sqrt(along * along - square * offset);
        return along < 0 && root >= 0 ? offset / (root - along) : Double.POSITIVE_INFINITY;
    }
}
