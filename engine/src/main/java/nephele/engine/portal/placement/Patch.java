package nephele.engine.portal.placement;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * One flat convex piece of surface, of a solid or of a mesh.
 *
 * @param normal of unit length
 * @param leastWidthMetres distance between the closest two parallel lines around it, or slightly more
 */
record Patch(
        List<Vec3> corners,
        boolean portalable,
        Vec3 normal,
        double areaSquareMetres,
        double leastWidthMetres,
        Aabb bounds) {
    /** Returns {@code null} for a piece of nearly zero area. */
    static Patch of(List<Vec3> corners, boolean portalable) {
        Vec3 doubled = doubledArea(corners);
        Vec3 normal = Directions.unit(doubled);
        double area = doubled.length() / 2;
        double longest = longestEdge(corners);
        if (normal == null || !(area > 1e-12 * longest * longest)) {
            return null;
        }
        return new Patch(corners, portalable, normal, area, 2 * area / longest, Aabb.of(corners));
    }

    private static Vec3 doubledArea(List<Vec3> corners) {
        Vec3 o = corners.get(0);
        var sum = Vec3.ZERO.toVector();
        for (int i = 2; i < corners.size(); i++) {
            Vec3 area = corners.get(i - 1).minus(o).cross(corners.get(i).minus(o));
            sum.add(area.x(), area.y(), area.z());
        }
        return new Vec3(sum.x, sum.y, sum.z);
    }

    private static double longestEdge(List<Vec3> corners) {
        double longest = 0;
        for (int i = 0; i < corners.size(); i++) {
            Vec3 next = corners.get((i + 1) % corners.size());
            longest = Math.max(longest, next.minus(corners.get(i)).length());
        }
        return longest;
    }

    /**
     * Returns true if it faces the plane's direction and none of its corners is off the plane; the normal of a sliver
     * is ignored.
     */
    boolean liesOn(PlaneFrame frame) {
        double cosine = normal.dot(frame.normal());
        boolean sliver = leastWidthMetres < Tolerance.SLIVER;
        if (!(cosine >= (sliver ? 0 : Tolerance.COPLANAR_COSINE))) {
            return false;
        }
        double most = Tolerance.coplanar(extent());
        return corners.stream().noneMatch(corner -> Math.abs(frame.height(corner)) > most);
    }

    private double extent() {
        double x = Math.max(Math.abs(bounds.minX()), Math.abs(bounds.maxX()));
        double y = Math.max(Math.abs(bounds.minY()), Math.abs(bounds.maxY()));
        return Math.max(Math.max(x, y), Math.max(Math.abs(bounds.minZ()), Math.abs(bounds.maxZ())));
    }
}
