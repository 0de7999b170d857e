package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.TriangleTangents;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.reference.MaterialTextures.Bare;
import nephele.engine.reference.MaterialTextures.Spot;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A model's triangles. No ray passes between two that share an edge. Only front faces are visible; both sides cast
 * shadows.
 */
final class TriangleMeshShape implements TracedShape {
    private final PlacedModel model;
    private final WorldTriangles mesh;
    private final double[] corners;
    private final SpatialIndex index;
    private final ItemRayTest meets;

    TriangleMeshShape(PlacedModel model) {
        this.model = model;
        mesh = model.triangles();
        corners = mesh.corners();
        List<Aabb> boxes = new ArrayList<>();
        for (int i = 0; i < mesh.count(); i++) {
            boxes.add(Aabb.of(List.of(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2))));
        }
        index = SpatialIndex.of(boxes);
        meets = (ray, triangle, limit) -> {
            double parameter = RayTriangleIntersection.hitParameter(ray, corners, 9 * triangle);
            return parameter >= 0 && parameter <= limit ? parameter : Double.POSITIVE_INFINITY;
        };
    }

    @Override
    public Aabb bounds() {
        return model.bounds();
    }

    /** Returns the parameter of the first front face. */
    @Override
    public double entry(Ray ray, double least) {
        RayHit hit = new RayHit();
        return nearest(ray, least, hit) ? hit.distance() : Double.POSITIVE_INFINITY;
    }

    private boolean nearest(Ray ray, double least, RayHit hit) {
        return index.nearest(ray, Double.POSITIVE_INFINITY, (r, triangle, limit) -> entry(r, triangle, least), hit);
    }

    private double entry(Ray ray, int triangle, double least) {
        double[] normals = mesh.faceNormals();
        double rate = normals[3 * triangle] * ray.directionX()
                + normals[3 * triangle + 1] * ray.directionY()
                + normals[3 * triangle + 2] * ray.directionZ();
        double parameter =
                rate < 0 ? RayTriangleIntersection.hitParameter(ray, corners, 9 * triangle) : Double.POSITIVE_INFINITY;
        return parameter >= Math.max(least, 0) ? parameter : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        return index.anyHit(ray, limit, meets);
    }

    @Override
    public boolean shadesItself() {
        return true;
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        RayHit hit = new RayHit();
        nearest(path.ray(), path.end(), hit);
        int triangle = hit.item();
        double[] weights = new double[3];
        RayTriangleIntersection.barycentricWeights(place, corners, 9 * triangle, weights);
        Vector3d normal = new Vector3d();
        double s = 0;
        double t = 0;
        for (int corner = 0; corner < 3; corner++) {
            Vec3 n = mesh.normal(triangle, corner);
            normal.add(weights[corner] * n.x(), weights[corner] * n.y(), weights[corner] * n.z());
            s += weights[corner] * mesh.s(triangle, corner);
            t += weights[corner] * mesh.t(triangle, corner);
        }
        Vec3 smooth = Vec3.of(normal.normalize());
        TriangleTangents texture = TriangleTangents.of(mesh, triangle);
        Spot spot = new Spot(
                s, t, texture.across(smooth).toVector(), texture.up(smooth).toVector());
        Bare bare =
                new Bare(path.item(), place, normal, mesh.faceNormal(triangle).toVector(), toEye);
        return MaterialTextures.covered(bare, looks.textures().skin(model.said().material()), spot);
    }
}
