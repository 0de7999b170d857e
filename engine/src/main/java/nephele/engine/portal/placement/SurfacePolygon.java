package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.TriangleSoup;
import nephele.engine.math.Vec3;

/**
 * A flat convex piece of surface, a face of a solid or a triangle of a mesh. It takes portals on its front.
 *
 * @param corners counter-clockwise seen from in front
 * @param normal of unit length; {@code null} for a piece of nearly zero area, which has no plane
 * @param leastWidthMetres distance between the closest two parallel lines around it, or slightly more
 */
public record SurfacePolygon(
        List<Vec3> corners,
        boolean portalable,
        Vec3 normal,
        double areaSquareMetres,
        double leastWidthMetres,
        Aabb bounds) {
    /** Returns a piece of surface with these corners. */
    public static SurfacePolygon of(List<Vec3> corners, boolean portalable) {
        Vec3 doubled = doubledArea(corners);
        double area = doubled.length() / 2;
        double longest = longestEdge(corners);
        Vec3 normal = area > 1e-12 * longest * longest ? Directions.unit(doubled) : null;
        return new SurfacePolygon(corners, portalable, normal, area, 2 * area / longest, Aabb.of(corners));
    }

    /** Returns the triangles of a mesh. */
    public static List<SurfacePolygon> of(TriangleSoup soup, boolean portalable) {
        List<SurfacePolygon> triangles = new ArrayList<>(soup.triangleCount());
        for (int at = 0; at < soup.vertices().length; at += 3) {
            triangles.add(of(List.of(corner(soup, at), corner(soup, at + 1), corner(soup, at + 2)), portalable));
        }
        return triangles;
    }

    /** Returns a triangle of a model. */
    static SurfacePolygon of(PlacedModel model, int triangle) {
        WorldTriangles mesh = model.triangles();
        return of(
                List.of(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)),
                model.authored().portalable());
    }

    private static Vec3 corner(TriangleSoup soup, int at) {
        int vertex = 3 * soup.vertices()[at];
        return new Vec3(soup.positions()[vertex], soup.positions()[vertex + 1], soup.positions()[vertex + 2]);
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

    /** Returns true if it has a plane. */
    boolean isFlat() {
        return normal != null;
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
