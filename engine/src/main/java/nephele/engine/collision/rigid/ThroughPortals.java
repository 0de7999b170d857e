package nephele.engine.collision.rigid;

import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/**
 * Finds the portals behind which a point of a shape is: the segment to it from the shape's centre crosses the aperture.
 */
final class ThroughPortals {
    /** Distance outside an aperture's edge up to which a part of a shape still counts as through it. */
    private static final double EDGE_METRES = 2e-3;

    /**
     * Returns the mask of the portals through which the point is.
     *
     * @param mask the portals on which the shape is active
     */
    long find(Portals portals, long mask, Vector3dc centre, Vector3dc point) {
        long through = 0;
        for (long left = mask; left != 0; left &= left - 1) {
            int i = Long.numberOfTrailingZeros(left);
            if (isThrough(portals.portal(i), centre, point)) {
                through |= 1L << i;
            }
        }
        return through;
    }

    private static boolean isThrough(Portal portal, Vector3dc centre, Vector3dc point) {
        double behind = portal.inFront(point.x(), point.y(), point.z());
        if (behind >= 0) {
            return false;
        }
        double before = Math.max(0, portal.inFront(centre.x(), centre.y(), centre.z()));
        double share = before / (before - behind);
        double across = portal.across(centre.x(), centre.y(), centre.z()) * (1 - share)
                + portal.across(point.x(), point.y(), point.z()) * share;
        double upward = portal.upward(centre.x(), centre.y(), centre.z()) * (1 - share)
                + portal.upward(point.x(), point.y(), point.z()) * share;
        return portal.aperture().outside(across, upward) <= EDGE_METRES;
    }
}
