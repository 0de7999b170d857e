package nephele.engine.render.pass.terrain;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.terrain.LayerPaint;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.render.resource.ResampledPicture;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Slot;
import nephele.engine.scene.SceneMaterials.Surface;

/** The colours of a terrain's layers, mixed once into one picture of the whole terrain, seen from above. */
final class BakedLayers {
    /** Pixels along each side. */
    static final int SIZE = 1024;

    private final HeightField field;
    private final TerrainLayers layers;
    private final Optional<LayerPaint> paint;
    private final double zeroHeight;
    private final List<Layer> pictures = new ArrayList<>();
    private final ColourDecoding.Codes codes;

    /**
     * A layer's colour, from the mipmap level whose pixels are about as large as those of the mixture.
     *
     * @param samples RGBA, {@code null} without a picture
     */
    private record Layer(Vec3 colour, double metres, int width, int height, byte[] samples) {
        static Layer of(Surface surface, SceneMaterials materials, double pixelMetres, ColourDecoding decoding) {
            Slot slot = surface.colour();
            Vec3 colour = surface.material().baseColour();
            double metres = surface.material().textureMetres();
            if (slot.array() < 0) {
                return new Layer(colour, metres, 1, 1, null);
            }
            Picture picture =
                    materials.colourArrays().get(slot.array()).layers().get(slot.layer());
            List<byte[]> below = ResampledPicture.mipLevels(picture, decoding);
            int width = picture.width();
            int height = picture.height();
            byte[] samples = picture.samples();
            for (int level = 0; level < below.size() && metres / width < pixelMetres; level++) {
                width = Math.max(width / 2, 1);
                height = Math.max(height / 2, 1);
                samples = below.get(level);
            }
            return new Layer(colour, metres, width, height, samples);
        }
    }

    private BakedLayers(StaticShape.HeightGrid grid, SceneMaterials materials, ColourDecoding decoding) {
        field = grid.field();
        layers = TerrainLayers.of(grid.authored());
        paint = grid.painted().map(map -> new LayerPaint(grid.authored(), map));
        zeroHeight = grid.authored().centre().y();
        codes = decoding.codes();
        double pixel = Math.max(field.cellX() * field.cellColumns(), field.cellZ() * field.cellRows()) / SIZE;
        for (int i = 0; i < layers.count(); i++) {
            Surface surface = materials.surfaces().get(materials.indexOf(layers.material(i)));
            pictures.add(Layer.of(surface, materials, pixel, decoding));
        }
        if (pictures.isEmpty()) {
            pictures.add(Layer.of(materials.surfaces().get(0), materials, pixel, decoding));
        }
    }

    /** Returns the mixture, its left at the least x, its top at the least z. */
    static Picture of(StaticShape.HeightGrid grid, SceneMaterials materials, ColourDecoding decoding) {
        BakedLayers baked = new BakedLayers(grid, materials, decoding);
        byte[] samples = new byte[4 * SIZE * SIZE];
        IntStream.range(0, SIZE).parallel().forEach(row -> baked.write(row, samples));
        return new Picture(SIZE, SIZE, 4, 8, samples);
    }

    private void write(int row, byte[] samples) {
        double[] weights = new double[pictures.size()];
        double[] rgb = new double[3];
        double z = field.origin().z() + (row + 0.5) / SIZE * field.cellZ() * field.cellRows();
        for (int column = 0; column < SIZE; column++) {
            double x = field.origin().x() + (column + 0.5) / SIZE * field.cellX() * field.cellColumns();
            weights[0] = 1;
            layers.weights(
                    HeightFieldSurface.y(field, x, z) - zeroHeight,
                    HeightFieldSurface.normal(field, x, z).y(),
                    weights);
            if (paint.isPresent()) {
                paint.get().over(x, z, weights);
            }
            Arrays.fill(rgb, 0);
            for (int layer = 0; layer < weights.length; layer++) {
                add(pictures.get(layer), weights[layer], x, z, rgb);
            }
            int at = 4 * (row * SIZE + column);
            for (int channel = 0; channel < 3; channel++) {
                samples[at + channel] = codes.nearest(rgb[channel]);
            }
            samples[at + 3] = (byte) 255;
        }
    }

    private void add(Layer layer, double weight, double x, double z, double[] rgb) {
        int at = 4
                * (pixel(z / layer.metres(), layer.height()) * layer.width()
                        + pixel(x / layer.metres(), layer.width()));
        Vec3 colour = layer.colour().scaled(weight);
        rgb[0] += colour.x() * texel(layer, at);
        rgb[1] += colour.y() * texel(layer, at + 1);
        rgb[2] += colour.z() * texel(layer, at + 2);
    }

    private double texel(Layer layer, int at) {
        return layer.samples() == null ? 1 : codes.linear(layer.samples()[at]);
    }

    private static int pixel(double repeats, int count) {
        return Math.min((int) ((repeats - Math.floor(repeats)) * count), count - 1);
    }
}
