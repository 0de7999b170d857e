package nephele.engine.level.appearance;

import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The mapping of a texture on a face: s grows to the right and t downwards as seen with world up upwards (for floors
 * and ceilings: s along +x); t = 0 at the picture's top row. The solid shader derives the same two directions for
 * normal maps.
 *
 * @param across unit direction in which s grows
 * @param up unit direction in which t falls
 */
public record FaceTexture(Vec3 across, Vec3 up, Axis s, Axis t) {
    /** Sine of elevation of the normal above which a face is a floor or ceiling. */
    private static final double HORIZONTAL = 0.999;

    /**
     * Converts metres along a direction to texture coordinates; whole repeats are subtracted, so that floats stay
     * exact.
     */
    record Axis(double origin, double metres, double whole) {
        double at(double along) {
            return (along - origin) / metres - whole;
        }
    }

    /**
     * Returns the mapping of a face.
     *
     * @param textureMetres side of the square that one repeat covers
     */
    public static FaceTexture of(BrushFace face, double textureMetres) {
        Vec3 normal = face.plane().normal();
        Vec3 across = across(normal);
        Vec3 up = normal.cross(across);
        return new FaceTexture(across, up, axis(face, across, textureMetres), axis(face, up.negated(), textureMetres));
    }

    /** Returns the unit direction in which s grows on a face with normal {@code n}. */
    public static Vec3 across(Vec3 n) {
        Vec3 s = Math.abs(n.y()) > HORIZONTAL
                ? new Vec3(1 - n.x() * n.x(), -n.y() * n.x(), -n.z() * n.x())
                : new Vec3(0, 1, 0).cross(n);
        return Directions.unit(s);
    }

    private static Axis axis(BrushFace face, Vec3 direction, double textureMetres) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (Vec3 corner : face.polygon()) {
            double along = corner.dot(direction);
            least = Math.min(least, along);
            most = Math.max(most, along);
        }
        return face.textureMapping() == TextureMapping.FACE
                ? new Axis(least, most - least, 0)
                : new Axis(0, textureMetres, Math.floor(least / textureMetres));
    }

    public double s(Vec3 p) {
        return s.at(p.dot(across));
    }

    public double t(Vec3 p) {
        return t.at(-p.dot(up));
    }
}
