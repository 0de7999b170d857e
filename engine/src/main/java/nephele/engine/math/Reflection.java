package nephele.engine.math;

import org.joml.Vector3d;

/**
 * The reflection at a plane. Points are mapped relative to {@code point}, so that a plane far from the origin costs no
 * precision.
 *
 * @param point any point of the plane
 * @param normal unit length
 */
public record Reflection(Vec3 point, Vec3 normal) implements Isometry {
    @Override
    public Vector3d point(Vector3d p) {
        double before =
                normal.x() * (p.x - point.x()) + normal.y() * (p.y - point.y()) + normal.z() * (p.z - point.z());
        return moved(p, -2 * before);
    }

    @Override
    public Vector3d direction(Vector3d v) {
        return moved(v, -2 * v.dot(normal.x(), normal.y(), normal.z()));
    }

    private Vector3d moved(Vector3d p, double alongNormal) {
        return p.add(alongNormal * normal.x(), alongNormal * normal.y(), alongNormal * normal.z());
    }

    @Override
    public boolean isReflection() {
        return true;
    }
}
