package nephele.engine.level.appearance;

import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;

/**
 * What a {@link nephele.engine.level.TexturePlacement} of a face changes: the place of the picture without one.
 *
 * @param across unit direction of the picture's right on the face
 * @param up unit direction of its up
 * @param pivot the point about which the picture is scaled and turned, only its position along the face counts
 * @param pivotFraction both texture coordinates of the pivot
 * @param uMetres width of one repeat
 * @param vMetres its height
 */
public record TextureFrame(Vec3 across, Vec3 up, Vec3 pivot, double pivotFraction, double uMetres, double vMetres) {
    /**
     * Returns the frame of a face.
     *
     * @param textureMetres side of the square that one repeat covers with {@link TextureMapping#WORLD}
     */
    public static TextureFrame of(BrushFace face, double textureMetres) {
        Vec3 normal = face.plane().normal();
        Vec3 across = FaceTexture.across(normal);
        Vec3 up = normal.cross(across);
        if (face.textureMapping() != TextureMapping.FACE) {
            return new TextureFrame(across, up, Vec3.ZERO, 0, textureMetres, textureMetres);
        }
        Extent u = Extent.of(face, across);
        Extent v = Extent.of(face, up);
        Vec3 middle = across.scaled(u.middle()).addScaled(v.middle(), up);
        return new TextureFrame(across, up, middle, 0.5, u.metres(), v.metres());
    }

    /** The part of a direction's axis that a face covers, in metres from the world's origin. */
    public record Extent(double least, double most) {
        public static Extent of(BrushFace face, Vec3 direction) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (Vec3 corner : face.polygon()) {
                double along = corner.dot(direction);
                least = Math.min(least, along);
                most = Math.max(most, along);
            }
            return new Extent(least, most);
        }

        public double metres() {
            return most - least;
        }

        public double middle() {
            return (least + most) / 2;
        }
    }

    /** Returns the picture's right when it is turned counter-clockwise as seen from outside. */
    public Vec3 turnedRight(double degrees) {
        return across.scaled(cosine(degrees)).addScaled(sine(degrees), up);
    }

    /** Returns the picture's up when it is turned counter-clockwise as seen from outside. */
    public Vec3 turnedUp(double degrees) {
        return up.scaled(cosine(degrees)).addScaled(-sine(degrees), across);
    }

    /** Exact for quarter turns, so that whole repeats meet after them. */
    private static double cosine(double degrees) {
        return sine(degrees + 90);
    }

    private static double sine(double degrees) {
        double turned = degrees % 360;
        if (turned % 90 == 0) {
            int quarters = (int) Math.round(turned / 90) & 3;
            return quarters == 1 ? 1 : quarters == 3 ? -1 : 0;
        }
        return StrictMath.sin(Math.toRadians(turned));
    }
}
