package nephele.editor.paint;

import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Material;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.appearance.TextureFrame;
import nephele.engine.math.Vec3;

/**
 * A face with the size of its material's picture.
 *
 * @param textureMetres side of the square that one repeat covers without a scale
 */
public record PaintedFace(BrushFace face, double textureMetres) {
    /**
     * Makes a painted face.
     *
     * @param material of the face; {@code null} for the default grey
     */
    public static PaintedFace of(BrushFace face, Material material) {
        return new PaintedFace(face, (material == null ? Material.DEFAULT_GREY : material).textureMetres());
    }

    /** Returns the placement of the picture; {@link TexturePlacement#NONE} if the face says nothing. */
    public TexturePlacement placement() {
        return face.texture() == null ? TexturePlacement.NONE : face.texture();
    }

    /** Returns this face with its picture elsewhere. */
    public PaintedFace with(TexturePlacement placement) {
        return new PaintedFace(face.with(placement), textureMetres);
    }

    FaceTexture texture() {
        return FaceTexture.of(face, textureMetres).unreduced();
    }

    TextureFrame frame() {
        return TextureFrame.of(face, textureMetres);
    }

    /** Returns the mean of the corners. */
    Vec3 middle() {
        Vec3 sum = Vec3.ZERO;
        for (Vec3 corner : face.polygon()) {
            sum = sum.plus(corner);
        }
        return sum.scaled(1.0 / face.polygon().size());
    }
}
