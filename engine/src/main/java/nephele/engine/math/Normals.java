package nephele.engine.math;

import org.joml.Matrix3dc;

/** Transforms surface normals by a linear map that may be non-uniform, mirrored or singular. */
public final class Normals {
    private Normals() {}

    /** Returns true if the map turns counter-clockwise triangles into clockwise ones. */
    public static boolean flipsWinding(Matrix3dc linear) {
        return determinantSign(linear) < 0;
    }

    /** Normalises the columns first, because the determinant of tiny scales underflows. */
    private static double determinantSign(Matrix3dc m) {
        Vec3 x = Directions.unit(m.m00(), m.m01(), m.m02());
        Vec3 y = Directions.unit(m.m10(), m.m11(), m.m12());
        Vec3 z = Directions.unit(m.m20(), m.m21(), m.m22());
        return x == null || y == null || z == null ? 0 : x.dot(y.cross(z));
    }

    /**
     * Returns the unit normal of the image of a surface: the cofactor matrix (inverse transpose times determinant,
     * which needs no inverse) times {@code normal}. The normal stays on the image of its side. If the map flattens the
     * surface to a line or point, the result is the direction perpendicular to that which is nearest to the image of
     * the old normal.
     */
    public static Vec3 transformed(Matrix3dc linear, Vec3 normal) {
        Vec3 x = new Vec3(linear.m00(), linear.m01(), linear.m02());
        Vec3 y = new Vec3(linear.m10(), linear.m11(), linear.m12());
        Vec3 z = new Vec3(linear.m20(), linear.m21(), linear.m22());
        Vec3 unit = combined(y.cross(z), z.cross(x), x.cross(y), normal);
        if (unit == null) {
            return flattened(linear, normal);
        }
        return flipsWinding(linear) ? unit.negated() : unit;
    }

    private static Vec3 combined(Vec3 a, Vec3 b, Vec3 c, Vec3 weight) {
        return Directions.unit(
                a.x() * weight.x() + b.x() * weight.y() + c.x() * weight.z(),
                a.y() * weight.x() + b.y() * weight.y() + c.y() * weight.z(),
                a.z() * weight.x() + b.z() * weight.y() + c.z() * weight.z());
    }

    private static Vec3 flattened(Matrix3dc linear, Vec3 normal) {
        Vec3 old = Directions.unit(normal);
        if (old == null) {
            return new Vec3(0, 1, 0);
        }
        Vec3 tangent = Directions.perpendicular(old);
        Vec3 first = image(linear, tangent);
        Vec3 second = image(linear, old.cross(tangent));
        Vec3 longer = first.length() >= second.length() ? first : second;
        Vec3 line = Directions.unit(longer);
        Vec3 inside = image(linear, old);
        Vec3 side = Directions.unit(inside);
        return perpendicularTo(line, side == null ? old : side);
    }

    /**
     * Returns the direction perpendicular to {@code line} that is nearest to {@code side}; {@code side} itself if
     * {@code line} is {@code null}.
     */
    private static Vec3 perpendicularTo(Vec3 line, Vec3 side) {
        if (line == null) {
            return side;
        }
        double along = side.dot(line);
        Vec3 rest = side.addScaled(-along, line);
        boolean parallel = rest.length() < 1e-6;
        return parallel ? Directions.perpendicular(line) : Directions.unit(rest);
    }

    private static Vec3 image(Matrix3dc m, Vec3 v) {
        return new Vec3(
                m.m00() * v.x() + m.m10() * v.y() + m.m20() * v.z(),
                m.m01() * v.x() + m.m11() * v.y() + m.m21() * v.z(),
                m.m02() * v.x() + m.m12() * v.y() + m.m22() * v.z());
    }
}
