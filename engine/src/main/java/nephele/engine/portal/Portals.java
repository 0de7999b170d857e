package nephele.engine.portal;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.math.Plane;
import org.joml.Vector3dc;

/**
 * The portals that exist at a time, and their pairing. A value: a shot makes another. Portals are identified by their
 * index here; a portal without a partner is closed.
 */
public final class Portals {
    public static final Portals NONE = new Portals(List.of(), List.of());
    /** The partner of a closed portal. */
    public static final int CLOSED = -1;

    private static final double EDGE_METRES = 2e-3;

    private final List<Portal> portals;
    private final List<Integer> partners;
    private final PortalTransform[] transforms;
    private final Plane[] planes;

    /** @param partners for each portal the index of its partner, or {@link #CLOSED} */
    public Portals(List<Portal> portals, List<Integer> partners) {
        this.portals = List.copyOf(portals);
        this.partners = List.copyOf(partners);
        transforms = new PortalTransform[portals.size()];
        planes = portals.stream().map(Portals::planeOf).toArray(Plane[]::new);
        for (int i = 0; i < transforms.length; i++) {
            int partner = partners.get(i);
            transforms[i] = partner == CLOSED ? null : PortalTransform.between(portals.get(i), portals.get(partner));
        }
    }

    private static Plane planeOf(Portal portal) {
        return Plane.through(portal.normal(), portal.centre());
    }

    /** Returns the portals with which a level starts, in its order. */
    public static Portals of(Level level) {
        List<String> ids = level.portals().stream().map(PortalSpec::id).toList();
        List<Portal> portals = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        for (PortalSpec spec : level.portals()) {
            portals.add(Portal.of(spec));
            partners.add(ids.indexOf(spec.linkedTo()));
        }
        return new Portals(portals, partners);
    }

    /** Returns the number of portals, closed ones included. */
    public int size() {
        return portals.size();
    }

    /** Returns a portal by its index. */
    public Portal portal(int index) {
        return portals.get(index);
    }

    /** Returns all portals, by their index. */
    public List<Portal> all() {
        return portals;
    }

    /** Returns the partner of each portal. */
    public List<Integer> partners() {
        return partners;
    }

    /** Returns the index of the portal's partner, or {@link #CLOSED}. */
    public int partner(int index) {
        return partners.get(index);
    }

    /** Returns the plane of a portal, with its normal towards the front. */
    public Plane plane(int index) {
        return planes[index];
    }

    /**
     * Finds behind which portals a point of a shape is: the straight line to it from the shape's centre crosses the plane
     * within the aperture. A point may be outside the aperture by {@link #EDGE_METRES}, as a part that touches its edge is.
     *
     * @param mask the portals to look at, bit i for index i
     * @return those of them that the point is behind
     */
    public long behind(long mask, Vector3dc centre, Vector3dc point) {
        long behind = 0;
        for (long left = mask; left != 0; left &= left - 1) {
            int i = Long.numberOfTrailingZeros(left);
            if (isThrough(portals.get(i), centre, point)) {
                behind |= 1L << i;
            }
        }
        return behind;
    }

    private static boolean isThrough(Portal portal, Vector3dc centre, Vector3dc point) {
        double behind = portal.inFront(point.x(), point.y(), point.z());
        if (behind >= 0) {
            return false;
        }
        double before = Math.max(0, portal.inFront(centre.x(), centre.y(), centre.z()));
        double fraction = before / (before - behind);
        double across = portal.across(centre.x(), centre.y(), centre.z()) * (1 - fraction)
                + portal.across(point.x(), point.y(), point.z()) * fraction;
        double upward = portal.upward(centre.x(), centre.y(), centre.z()) * (1 - fraction)
                + portal.upward(point.x(), point.y(), point.z()) * fraction;
        return portal.aperture().outside(across, upward) <= EDGE_METRES;
    }

    /** Returns true if a portal has a partner. */
    public boolean isOpen(int index) {
        return transforms[index] != null;
    }

    /** Returns the map from an open portal to its partner, {@code null} for a closed one. */
    public PortalTransform transform(int index) {
        return transforms[index];
    }
}
