package nephele.engine.scene.impostor;

import nephele.engine.asset.Picture;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.math.Vec3;

/** The picture of a kind from one side, as a sprite that stands for it: colour without light, and coverage. */
public final class KindPicture {
    private static final Vec3 FROM = new Vec3(0, 0, 1);

    private KindPicture() {}

    /**
     * Draws the view of an impostor from +z without its border. The result's sides are the width and the height of the
     * upright cylinder around the kind.
     *
     * @param picture of the material's texture, 8-bit RGBA; {@code null} without one
     * @param texels along a side of the view, a multiple of 32; 30 of 32 are within the border
     * @return 8-bit RGBA with straight alpha
     */
    public static Picture of(KindShape shape, Material material, Picture picture, ColourDecoding decoding, int texels) {
        AtlasImage view = new AtlasImage(texels);
        new ViewRaster(shape, AtlasView.of(FROM, shape), texels)
                .resolve(new Albedo(material, picture, decoding), view, 0, 0);
        int side = (int) (ImpostorAtlas.FILLED * texels);
        int border = (texels - side) / 2;
        ColourDecoding.Codes codes = decoding.codes();
        byte[] rgba = new byte[4 * side * side];
        for (int i = 0; i < side * side; i++) {
            int x = border + i % side;
            int y = border + side - 1 - i / side;
            float coverage = view.value(x, y, AtlasImage.ALPHA);
            for (int channel = 0; channel < AtlasImage.ALPHA && coverage > 0; channel++) {
                rgba[4 * i + channel] = codes.nearest(view.value(x, y, channel) / coverage);
            }
            rgba[4 * i + AtlasImage.ALPHA] = (byte) Math.round(255 * coverage);
        }
        return new Picture(side, side, 4, 8, rgba);
    }
}
