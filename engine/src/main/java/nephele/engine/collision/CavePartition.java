package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/**
 * Separates two aperture volumes that would overlap. Each keeps the points that are deeper behind its portal than
 * behind the other; for portals side by side in one wall, the points on its side of the middle between them.
 */
final class CavePartition {
    /** Length of the difference of two unit normals below which portals count as parallel. */
    private static final double SAME_WAY = 0.05;

    private CavePartition() {}

    /** Returns the plane behind which the first portal's part is; {@code null} when the apertures overlap. */
    static Plane between(Portal a, Portal b) {
        Vec3 n = a.normal();
        Vec3 m = b.normal();
        Vec3 difference = new Vec3(n.x() - m.x(), n.y() - m.y(), n.z() - m.z());
        double length = length(difference);
        if (length < SAME_WAY) {
            return sideBySide(a, b);
        }
        Vec3 unit = new Vec3(difference.x() / length, difference.y() / length, difference.z() / length);
        // The plane n · (p − a) = m · (p − b), evaluated at a's centre, where the numbers are small.
        double atCentre = b.inFront(a.centre().x(), a.centre().y(), a.centre().z()) / length;
        Vec3 point = new Vec3(
                a.centre().x() + atCentre * unit.x(),
                a.centre().y() + atCentre * unit.y(),
                a.centre().z() + atCentre * unit.z());
        return Cave.through(unit, point);
    }

    private static double length(Vec3 v) {
        return Math.sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
    }

    /**
     * Separates parallel portals: two convex polygons that do not overlap are separated along the normal of an edge.
     */
    private static Plane sideBySide(Portal a, Portal b) {
        Plane fromA = widestGap(a, b);
        Plane fromB = widestGap(b, a);
        if (fromA == null || fromB == null) {
            return fromA != null ? fromA : opposite(fromB);
        }
        return gap(fromA, a, b) >= gap(opposite(fromB), a, b) ? fromA : opposite(fromB);
    }

    private static Plane opposite(Plane plane) {
        return plane == null ? null : new Plane(-plane.nx(), -plane.ny(), -plane.nz(), -plane.distance());
    }

    private static Plane widestGap(Portal a, Portal b) {
        Plane best = null;
        double widest = -1e-9;
        for (int i = 0; i < a.aperture().corners(); i++) {
            Vec3 on = a.world(a.aperture().cornerX(i), a.aperture().cornerY(i), 0);
            Plane edge = Cave.through(edgeNormal(a, i), on);
            double nearest = least(edge, b);
            if (nearest > widest) {
                widest = nearest;
                best = new Plane(edge.nx(), edge.ny(), edge.nz(), edge.distance() + nearest / 2);
            }
        }
        return best;
    }

    private static Vec3 edgeNormal(Portal portal, int edge) {
        Vec3 origin = portal.centre();
        Vec3 end = portal.world(
                portal.aperture().edgeNormalX(edge), portal.aperture().edgeNormalY(edge), 0);
        return new Vec3(end.x() - origin.x(), end.y() - origin.y(), end.z() - origin.z());
    }

    private static double gap(Plane plane, Portal a, Portal b) {
        return least(plane, b) + least(opposite(plane), a);
    }

    private static double least(Plane plane, Portal portal) {
        return corners(portal).stream().mapToDouble(plane::signedDistance).min().orElse(0);
    }

    /** Returns the aperture's corners in world coordinates. */
    static List<Vec3> corners(Portal portal) {
        Aperture aperture = portal.aperture();
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < aperture.corners(); i++) {
            corners.add(portal.world(aperture.cornerX(i), aperture.cornerY(i), 0));
        }
        return corners;
    }
}
