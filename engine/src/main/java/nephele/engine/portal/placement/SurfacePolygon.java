package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.TriangleSoup;
import nephele.engine.math.Vec3;

/**
 * A flat convex piece of surface that belongs to no solid: a triangle of a mesh. It stops shots from both sides and
 * takes portals on its front.
 *
 * @param corners counter-clockwise seen from in front
 */
public record SurfacePolygon(List<Vec3> corners, boolean portalable) {
    /** Returns the triangles of a mesh. */
    public static List<SurfacePolygon> of(TriangleSoup soup, boolean portalable) {
        List<SurfacePolygon> triangles = new ArrayList<>(soup.triangleCount());
        for (int at = 0; at < soup.vertices().length; at += 3) {
            triangles.add(new SurfacePolygon(
                    List.of(corner(soup, at), corner(soup, at + 1), corner(soup, at + 2)), portalable));
        }
        return triangles;
    }

    /** Returns a triangle of a model. */
    static SurfacePolygon of(PlacedModel model, int triangle) {
        WorldTriangles mesh = model.triangles();
        return new SurfacePolygon(
                List.of(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)),
                model.said().portalable());
    }

    private static Vec3 corner(TriangleSoup soup, int at) {
        int vertex = 3 * soup.vertices()[at];
        return new Vec3(soup.positions()[vertex], soup.positions()[vertex + 1], soup.positions()[vertex + 2]);
    }
}
