package nephele.engine.level.appearance;

import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.TexturePlacement;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The mapping of a texture on a face: s grows to the right and t downwards as seen with world up upwards (for floors
 * and ceilings: s along +x); t = 0 at the picture's top row. A {@link TexturePlacement} scales, turns and shifts the
 * picture. The solid shader derives the same two directions for normal maps.
 *
 * @param across unit direction in which s grows
 * @param up unit direction in which t falls
 */
public record FaceTexture(Vec3 across, Vec3 up, Axis s, Axis t) {
    /** Least outward component of a mapped normal; a smaller one could bend the normal below the face. */
    public static final double MIN_OUTWARD = 0.1;

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

        private Axis unreduced() {
            return new Axis(origin, metres, 0);
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
        if (face.texture() != null) {
            return placed(face, TextureFrame.of(face, textureMetres), face.texture());
        }
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
        TextureFrame.Extent extent = TextureFrame.Extent.of(face, direction);
        return face.textureMapping() == TextureMapping.FACE
                ? new Axis(extent.least(), extent.metres(), 0)
                : new Axis(0, textureMetres, Math.floor(extent.least() / textureMetres));
    }

    private static FaceTexture placed(BrushFace face, TextureFrame frame, TexturePlacement placement) {
        Vec3 right = frame.turnedRight(placement.rotationDegrees());
        Vec3 upwards = frame.turnedUp(placement.rotationDegrees());
        Vec3 across = placement.scaleU() < 0 ? right.negated() : right;
        Vec3 up = placement.scaleV() < 0 ? upwards.negated() : upwards;
        Vec3 pivot = frame.pivot()
                .addScaled(placement.shiftUMetres(), frame.across())
                .addScaled(placement.shiftVMetres(), frame.up());
        double sMetres = frame.uMetres() * Math.abs(placement.scaleU());
        double tMetres = frame.vMetres() * Math.abs(placement.scaleV());
        Axis s = new Axis(pivot.dot(across) - frame.pivotFraction() * sMetres, sMetres, 0);
        Axis t = new Axis(-pivot.dot(up) - frame.pivotFraction() * tMetres, tMetres, 0);
        return new FaceTexture(across, up, reduced(face, across, s), reduced(face, up.negated(), t));
    }

    private static Axis reduced(BrushFace face, Vec3 direction, Axis axis) {
        double least = TextureFrame.Extent.of(face, direction).least();
        return new Axis(axis.origin, axis.metres, Math.floor(axis.at(least)));
    }

    /** Returns this mapping without the subtraction of whole repeats. */
    public FaceTexture unreduced() {
        return new FaceTexture(across, up, s.unreduced(), t.unreduced());
    }

    /** Returns the width of one repeat. */
    public double sMetres() {
        return s.metres;
    }

    /** Returns the height of one repeat. */
    public double tMetres() {
        return t.metres;
    }

    public double s(Vec3 p) {
        return s.at(p.dot(across));
    }

    public double t(Vec3 p) {
        return t.at(-p.dot(up));
    }

    /**
     * Returns the normal that a normal map gives a face, the twin of {@code normal-map.glsl}.
     *
     * @param texel red, green, blue of the map, 0–1
     * @param across direction in which the texture's u grows on the face, {@code up} that of its v
     */
    public static Vector3d mappedNormal(Vector3dc texel, Vector3dc faceNormal, Vector3dc across, Vector3dc up) {
        Vector3d n = new Vector3d(faceNormal).mul(Math.max(texel.z() * 2 - 1, MIN_OUTWARD));
        n.fma(texel.x() * 2 - 1, across).fma(texel.y() * 2 - 1, up);
        return n.mul(1 / Math.sqrt(Math.max(n.lengthSquared(), 1e-8)));
    }
}
