package nephele.engine.level.placed;

import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The directions in which the texture coordinates of a triangle of a mesh grow. The shader computes them from
 * differences between neighbouring pixels, which are equal on a flat triangle.
 *
 * @param right the direction of growing s, any length; zero if s does not grow
 * @param down the direction of growing t
 */
public record TriangleTangents(Vec3 right, Vec3 down) {
    public static TriangleTangents of(WorldTriangles mesh, int triangle) {
        Vec3 n = mesh.faceNormal(triangle);
        Vec3 a = mesh.corner(triangle, 0);
        Vec3 ab = mesh.corner(triangle, 1).minus(a);
        Vec3 ac = mesh.corner(triangle, 2).minus(a);
        Vec3 alongAb = ac.cross(n);
        Vec3 alongAc = n.cross(ab);
        double area = n.dot(ab.cross(ac));
        double s = mesh.s(triangle, 0);
        double t = mesh.t(triangle, 0);
        return new TriangleTangents(
                Directions.combined(
                        alongAb, (mesh.s(triangle, 1) - s) / area, alongAc, (mesh.s(triangle, 2) - s) / area),
                Directions.combined(
                        alongAb, (mesh.t(triangle, 1) - t) / area, alongAc, (mesh.t(triangle, 2) - t) / area));
    }

    /** Returns the unit direction in which s grows on a surface with this normal. */
    public Vec3 across(Vec3 normal) {
        Vec3 along = along(right, normal);
        return along == null ? FaceTexture.across(normal) : along;
    }

    /** Returns the unit direction in which t falls on a surface with this normal. */
    public Vec3 up(Vec3 normal) {
        Vec3 along = along(down.negated(), normal);
        return along == null ? normal.cross(across(normal)) : along;
    }

    private static Vec3 along(Vec3 direction, Vec3 normal) {
        double off = direction.dot(normal);
        return Directions.unit(direction.addScaled(-off, normal));
    }
}
