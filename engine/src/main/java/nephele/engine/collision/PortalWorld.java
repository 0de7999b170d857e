package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.portal.ground.GroundSeat;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The static world as bodies collide with it near portals: this side is cut open behind each aperture and holds the
 * other side's solids there. A body uses the world of the portals on which it is <em>active</em>: its centre is in
 * front of them and it reaches their neighbourhood. Bit i of a mask is the portal with index i. Each mask's world is
 * built once, on first use. Not thread-safe.
 */
public final class PortalWorld {
    /** Number of bits of a mask: portals with a greater index are closed. */
    public static final int MOST_PORTALS = Long.SIZE;

    /** Distance in front of an exit's centre at which a solid makes the exit unusable. */
    private static final double EXIT_CLEARANCE_METRES = 1e-3;

    /** Distance at which the world is opened; larger than the skin at which contact begins. */
    private static final double MARGIN_METRES = 0.02;

    /** A centre at most this far behind the plane counts as in front: it has just come out of the portal. */
    private static final double ROUNDING_METRES = 1e-9;

    private static final Vector3dc STILL = new Vector3d();

    private final CollisionWorld statics;
    private final Portals portals;
    private final ApertureCutter cutter;
    private final long open;
    private final RayCast cast = new RayCast();
    private final Map<Long, CollisionWorld> worlds = new TreeMap<>();

    /** The pair that {@link #isActive} compares, and the part of the shape behind the portal, in its plane. */
    private Portal portal;

    private RoundedHull shape;
    private double x;
    private double y;
    private double leastX;
    private double mostX;
    private double leastY;
    private double mostY;

    private PortalWorld(CollisionWorld statics, Portals portals) {
        this.statics = statics;
        this.portals = portals;
        cutter = new ApertureCutter(statics, portals);
        long mask = 0;
        for (int i = 0; i < Math.min(portals.size(), MOST_PORTALS); i++) {
            mask |= portals.isOpen(i) ? 1L << i : 0;
        }
        open = mask;
    }

    /** Returns a world without portals. */
    public static PortalWorld of(CollisionWorld statics) {
        return new PortalWorld(statics, Portals.NONE);
    }

    /** Returns the world with these portals; pairs with an exit that is blocked by a solid are closed. */
    public static PortalWorld of(CollisionWorld statics, Portals portals) {
        return new PortalWorld(statics, withValidExits(statics, portals));
    }

    private static Portals withValidExits(CollisionWorld statics, Portals portals) {
        List<Integer> partners = new ArrayList<>(portals.partners());
        boolean changed = false;
        for (int i = 0; i < portals.size(); i++) {
            int partner = portals.partner(i);
            boolean closed =
                    partner != Portals.CLOSED && !(isValid(statics, portals, i) && isValid(statics, portals, partner));
            if (closed) {
                changed = true;
                partners.set(i, Portals.CLOSED);
            }
        }
        return changed ? new Portals(portals.all(), partners) : portals;
    }

    private static boolean isValid(CollisionWorld statics, Portals portals, int index) {
        Vec3 outside = portals.portal(index).world(0, 0, EXIT_CLEARANCE_METRES);
        ItemList near = new ItemList();
        statics.overlapping(
                new Aabb(outside.x(), outside.y(), outside.z(), outside.x(), outside.y(), outside.z()), near);
        for (int i = 0; i < near.size(); i++) {
            if (statics.collider(near.get(i)).containsStrictly(outside.x(), outside.y(), outside.z())) {
                return false;
            }
        }
        return index < MOST_PORTALS;
    }

    /** Returns the world without openings. */
    public CollisionWorld statics() {
        return statics;
    }

    /** Returns how far the ground around a portal lies below it; {@link GroundSeat#NO_GROUND} for one on a wall. */
    public double groundStepMetres(int portal) {
        return cutter.groundStepMetres(portal);
    }

    /** Returns the part of a motion before the first solid, 0 to 1; portals count as wall. */
    public double free(Vector3dc from, Vector3dc path) {
        var ray = new Ray(from.x(), from.y(), from.z(), path.x(), path.y(), path.z());
        return cast.cast(statics, ray, 1) ? cast.distance() : 1;
    }

    /** Returns the given portals, with those of unusable exits closed; portal crossings must be tested with these. */
    public Portals portals() {
        return portals;
    }

    /**
     * Returns the mask of open portals on which a shape is active while its centre moves from {@code at} by
     * {@code path}.
     */
    public long active(RoundedHull shape, Vector3dc at, Vector3dc path) {
        long mask = 0;
        for (int i = 0; i < Math.min(portals.size(), MOST_PORTALS); i++) {
            if (portals.isOpen(i) && isActive(portals.portal(i), shape, at, path)) {
                mask |= 1L << i;
            }
        }
        return mask;
    }

    /** Returns true if a moving shape comes so near to an aperture that it must collide with the world opened there. */
    private boolean isActive(Portal of, RoundedHull body, Vector3dc at, Vector3dc path) {
        portal = of;
        shape = body;
        double height = portal.inFront(at.x(), at.y(), at.z());
        if (height < -ROUNDING_METRES) {
            return false;
        }
        Vec3 n = portal.normal();
        double lowest = height + Math.min(0, dot(n, path));
        if (lowest - shape.reachMetres() > MARGIN_METRES || lowest + shape.support(-1, n) > MARGIN_METRES) {
            return false;
        }
        x = portal.across(at.x(), at.y(), at.z());
        y = portal.upward(at.x(), at.y(), at.z());
        double halfX = portal.aperture().widthMetres() / 2 + MARGIN_METRES;
        double halfY = portal.aperture().heightMetres() / 2 + MARGIN_METRES;
        if (!overlaps(portal.frame().right(), x, path, halfX)
                || !overlaps(portal.frame().up(), y, path, halfY)) {
            return false;
        }
        measureBehind(height);
        return isPartBehind() ? isThrough() : !endsAround(height, path);
    }

    /**
     * Returns true if the shape ends with its centre in front of the plane and reaches behind the plane only around the
     * wall's edge.
     */
    private boolean endsAround(double height, Vector3dc path) {
        double atEnd = height + dot(portal.normal(), path);
        if (!(atEnd >= 0)) {
            return false;
        }
        x += dot(portal.frame().right(), path);
        y += dot(portal.frame().up(), path);
        measureBehind(atEnd);
        return isPartBehind() && !isThrough();
    }

    private static double dot(Vec3 axis, Vector3dc v) {
        return axis.x() * v.x() + axis.y() * v.y() + axis.z() * v.z();
    }

    private boolean overlaps(Vec3 axis, double from, Vector3dc path, double half) {
        double along = dot(axis, path);
        return from + Math.min(0, along) + shape.support(-1, axis) <= half
                && from + Math.max(0, along) + shape.support(1, axis) >= -half;
    }

    private boolean isPartBehind() {
        return leastX <= mostX;
    }

    /**
     * Returns true if the part behind the plane overlaps the aperture's bounding rectangle, so that it is not beyond
     * the wall's edge.
     */
    private boolean isThrough() {
        return leastX <= portal.aperture().widthMetres() / 2
                && mostX >= -portal.aperture().widthMetres() / 2
                && leastY <= portal.aperture().heightMetres() / 2
                && mostY >= -portal.aperture().heightMetres() / 2;
    }

    /**
     * Finds the bounding rectangle, in the portal's plane, of the shape's part at the plane or behind it.
     *
     * @param height of the shape's centre in front of the plane
     */
    private void measureBehind(double height) {
        leastX = Double.POSITIVE_INFINITY;
        mostX = Double.NEGATIVE_INFINITY;
        leastY = Double.POSITIVE_INFINITY;
        mostY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < shape.corePoints(); i++) {
            double depth = -(height + core(i, portal.normal()));
            if (depth > -shape.radiusMetres()) {
                double ahead = Math.max(0, -depth);
                include(i, i, 0, Math.sqrt(shape.radiusMetres() * shape.radiusMetres() - ahead * ahead));
            }
            for (int j = 0; j < i; j++) {
                double other = -(height + core(j, portal.normal()));
                if (Math.min(depth, other) < 0 && Math.max(depth, other) > 0) {
                    include(i, j, depth / (depth - other), shape.radiusMetres());
                }
            }
        }
    }

    private double core(int point, Vec3 axis) {
        return shape.core(point, 0) * axis.x() + shape.core(point, 1) * axis.y() + shape.core(point, 2) * axis.z();
    }

    /** Extends the rectangle by a disc around a point between two core points. */
    private void include(int from, int to, double fraction, double radius) {
        Vec3 right = portal.frame().right();
        Vec3 up = portal.frame().up();
        double across = x + core(from, right) + fraction * (core(to, right) - core(from, right));
        double upward = y + core(from, up) + fraction * (core(to, up) - core(from, up));
        leastX = Math.min(leastX, across - radius);
        mostX = Math.max(mostX, across + radius);
        leastY = Math.min(leastY, upward - radius);
        mostY = Math.max(mostY, upward + radius);
    }

    /** Returns the mask of open portals on which a shape is active while its centre stays at a place. */
    public long active(RoundedHull shape, Vector3dc at) {
        return active(shape, at, STILL);
    }

    /**
     * Returns the solids for a body active on these portals; the static world itself for none. Closed portals are wall.
     */
    public CollisionWorld openedFor(long activeMask) {
        long mask = activeMask & open;
        if (mask == 0) {
            return statics;
        }
        CollisionWorld world = worlds.get(mask);
        if (world == null) {
            world = cutter.open(mask);
            worlds.put(mask, world);
        }
        return world;
    }

    /**
     * A cache of the last requested portal space: it is rebuilt only when the portals change, never in a tick without a
     * shot.
     */
    public static final class Cache {
        private final CollisionWorld statics;
        private PortalWorld last;

        public Cache(CollisionWorld statics) {
            this.statics = statics;
            last = PortalWorld.of(statics, Portals.NONE);
        }

        public PortalWorld of(Portals portals) {
            if (last.portals() != portals) {
                last = PortalWorld.of(statics, portals);
            }
            return last;
        }
    }
}
