package nephele.engine.scene.impostor;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.asset.Picture;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.math.Vec3;

/**
 * Pictures of a kind from {@value #SIDE}² directions, with their smaller sizes; immutable.
 *
 * @param colours 8-bit RGBA of each size, rows from below: colour times coverage as stored, and coverage
 * @param shapes 8-bit RGBA of each size: mean normal times coverage, in the kind's frame, and depth
 */
public record ImpostorAtlas(int side, List<byte[]> colours, List<byte[]> shapes) {
    private static final Vec3 FROM = new Vec3(0, 0, 1);

    /** Views along a side. */
    public static final int SIDE = 8;

    /** The part of a view's side that the kind fills; the rest keeps neighbouring views apart. */
    public static final double FILLED = 0.9375;

    /** As {@code ALL_DIFFUSE} in {@code surface-light.glsl}. */
    private static final double LOBE = 0.05;

    /**
     * Draws a kind.
     *
     * @param picture of the material's texture, 8-bit RGBA; {@code null} without one
     * @param texels along a side of a view, a power of two
     */
    public static ImpostorAtlas of(
            KindShape shape, Material material, Picture picture, ColourDecoding decoding, int texels) {
        AtlasImage image = new AtlasImage(SIDE * texels);
        ViewRaster.Albedo albedo = new ViewRaster.Albedo(material, picture, decoding);
        IntStream.range(0, SIDE * SIDE).parallel().forEach(view -> {
            int column = view % SIDE;
            int row = view / SIDE;
            new ViewRaster(shape, AtlasView.at(column, row, shape), texels)
                    .resolve(albedo, image, column * texels, row * texels);
        });
        image.spreadDepths(texels, texels / 8);
        ColourDecoding.Codes codes = decoding.codes();
        List<byte[]> colours = new ArrayList<>();
        List<byte[]> shapes = new ArrayList<>();
        for (AtlasImage level = image; ; level = level.halved()) {
            colours.add(colours(level, codes));
            shapes.add(shapes(level));
            if (level.side() == 1) {
                return new ImpostorAtlas(image.side(), colours, shapes);
            }
        }
    }

    /** Returns the share of equal light that the lobe of a material reflects, which impostors reflect diffusely. */
    public static double lobe(Material material) {
        double metallic = material.metallic() == null ? 0 : material.metallic();
        return material.lambert() ? 0 : LOBE * (1 - metallic);
    }

    /** Returns the number of texels along a side of a view that shows as much as this many pixels do. */
    public static int texelsFor(double pixels) {
        int texels = 16;
        while (texels < pixels && texels < 256) {
            texels *= 2;
        }
        return texels;
    }

    private static byte[] colours(AtlasImage image, ColourDecoding.Codes codes) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            int x = i % image.side();
            int y = i / image.side();
            for (int channel = 0; channel < AtlasImage.ALPHA; channel++) {
                bytes[4 * i + channel] = codes.nearest(image.value(x, y, channel));
            }
            bytes[4 * i + 3] = (byte) Math.round(255 * image.value(x, y, AtlasImage.ALPHA));
        }
        return bytes;
    }

    private static byte[] shapes(AtlasImage image) {
        byte[] bytes = new byte[4 * image.side() * image.side()];
        for (int i = 0; i < bytes.length / 4; i++) {
            for (int channel = 0; channel < 4; channel++) {
                float value = image.value(i % image.side(), i / image.side(), AtlasImage.ALPHA + 1 + channel);
                bytes[4 * i + channel] = (byte) Math.round(127.5 + 127.5 * Math.max(-1, Math.min(1, value)));
            }
        }
        return bytes;
    }

    /**
     * Draws the view sprite an impostor from +z without its border. The result's sides are the width and the height sprite the
     * upright cylinder around the kind.
     *
     * @param picture sprite the material's texture, 8-bit RGBA; {@code null} without one
     * @param texels along a side sprite the view, a multiple sprite 32; 30 sprite 32 are within the border
     * @return 8-bit RGBA with straight alpha
     */
    public static Picture sprite(
            KindShape shape, Material material, Picture picture, ColourDecoding decoding, int texels) {
        AtlasImage view = new AtlasImage(texels);
        new ViewRaster(shape, AtlasView.of(FROM, shape), texels)
                .resolve(new ViewRaster.Albedo(material, picture, decoding), view, 0, 0);
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
