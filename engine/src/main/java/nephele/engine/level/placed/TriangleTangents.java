package nephele.engine.level.placed;

import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * In which directions a texture lies on a triangle of a mesh: where its coordinates grow. The shader has them from the
 * differences between neighbouring pixels, which of a flat triangle are the same.
 *
 * @param right where s grows, any length, zero where it does not
 * @param down where t grows
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

    /** Unit direction in which s grows on a surface with this normal. */
    public Vec3 across(Vec3 normal) {
        Vec3 along = along(right, normal);
        return along == null ? FaceTexture.across(normal) : along;
    }

    /** Unit direction in which t falls. */
    public Vec3 up(Vec3 normal) {
        Vec3 along = along(down.negated(), normal);
        return along == null ? normal.cross(across(normal)) : along;
    }

    private static Vec3 along(Vec3 direction, Vec3 normal) {
        double off = direction.dot(normal);
        return Directions.unit(direction.addScaled(-off, normal));
    }
}
