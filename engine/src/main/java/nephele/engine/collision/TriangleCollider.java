package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Directions;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A triangle of a mesh as a solid: a flat pyramid below it. Its sides slope inwards from the triangle's edges, so that
 * neighbours in one plane join like abutting floors. Sweeps are continuous, so that no speed passes through it.
 */
final class TriangleCollider {
    /** Greatest depth of the pyramid; less for small triangles. */
    static final double DEPTH_METRES = 0.02;

    private static final double DEPTH_SHARE = 0.25;

    private TriangleCollider() {}

    static List<Collider> of(String id, WorldTriangles mesh) {
        List<Collider> sheets = new ArrayList<>(mesh.count());
        for (int i = 0; i < mesh.count(); i++) {
            sheets.add(of(id, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), mesh.faceNormal(i)));
        }
        return sheets;
    }

    /** @param normal unit normal of the side on which the corners are counter-clockwise */
    static Collider of(String id, Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
        Vec3[] corners = {a, b, c, null};
        corners[3] = apex(corners, normal);
        return new Collider(id, corners);
    }

    /** Returns the apex below the triangle's incentre, where the three sides are equally steep. */
    private static Vec3 apex(Vec3[] p, Vec3 normal) {
        double a = p[2].minus(p[1]).length();
        double b = p[0].minus(p[2]).length();
        double c = p[1].minus(p[0]).length();
        double around = a + b + c;
        Vec3 doubled = p[1].minus(p[0]).cross(p[2].minus(p[0]));
        double depth = Math.min(DEPTH_METRES, DEPTH_SHARE * doubled.length() / around);
        return new Vec3(
                (a * p[0].x() + b * p[1].x() + c * p[2].x()) / around - depth * normal.x(),
                (a * p[0].y() + b * p[1].y() + c * p[2].y()) / around - depth * normal.y(),
                (a * p[0].z() + b * p[1].z() + c * p[2].z()) / around - depth * normal.z());
    }

    /** Returns the pyramid with four faces, the triangle first. */
    static ConvexPolyhedron shape(Vec3[] p) {
        int[][] faces = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
        List<ConvexPolyhedron.Face> made = new ArrayList<>();
        for (int i = 0; i < faces.length; i++) {
            List<Vec3> ring = List.of(p[faces[i][0]], p[faces[i][1]], p[faces[i][2]]);
            Vec3 n = ring.get(1).minus(ring.get(0)).cross(ring.get(2).minus(ring.get(0)));
            Vec3 unit = Directions.unit(n.x(), n.y(), n.z());
            made.add(new ConvexPolyhedron.Face(i, Plane.through(unit, ring.get(0)), ring));
        }
        List<Vec3> vertices = List.of(p);
        return new ConvexPolyhedron(List.copyOf(made), vertices, Aabb.of(vertices));
    }
}
