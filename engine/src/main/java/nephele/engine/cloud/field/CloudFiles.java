package nephele.engine.cloud.field;

import java.util.function.IntToDoubleFunction;
import java.util.function.LongFunction;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;

/**
 * The files and tables of a cloud's density, decoded; they are the same at all times. Pictures are clouds as seen from
 * above, with −z at the top, and become one layer of voxels.
 *
 * @param voxels densities of a grid or picture, or the coverage map of noise; {@code null} for none
 * @param areDepths true if the voxels are the vertical optical depths of columns
 * @param tables of noise; {@code null} for another density
 */
record CloudFiles(VoxelGrid voxels, boolean areDepths, CloudTables tables) {
    /** Edge of the square that a picture covers in a layer, which repeats it. */
    static final double TILE_METRES = 10_000;

    /** The greatest alpha that counts; 1 would be an infinite optical depth. */
    private static final double OPAQUE = 254.5 / 255;

    /**
     * Reads the files of a cloud.
     *
     * @param tables makes or remembers the tables of a seed
     * @throws AssetException if a picture or grid is unusable
     */
    static CloudFiles of(Cloud cloud, AssetSource assets, LongFunction<CloudTables> tables) {
        if (cloud.density() instanceof Cloud.Density.Grid grid) {
            return new CloudFiles(VoxelGrid.read(grid.file(), assets.bytes(grid.file())), false, null);
        }
        if (cloud.density() instanceof Cloud.Density.Image image) {
            Picture picture = picture(image.file(), assets);
            return new CloudFiles(densities(picture), hasAlpha(picture), null);
        }
        if (cloud.density() instanceof Cloud.Density.Noise noise) {
            String map = noise.coverageMap();
            return new CloudFiles(map == null ? null : greys(picture(map, assets)), false, tables.apply(noise.seed()));
        }
        return new CloudFiles(null, false, null);
    }

    private static Picture picture(String file, AssetSource assets) {
        return PictureDecoder.decodeNumbers(file, assets.bytes(file));
    }

    private static boolean hasAlpha(Picture picture) {
        return picture.channels() == 2 || picture.channels() == 4;
    }

    /** Returns the optical depths −ln(1 − alpha) of the columns of a picture with alpha, otherwise the greys. */
    static VoxelGrid densities(Picture picture) {
        if (!hasAlpha(picture)) {
            return greys(picture);
        }
        int alpha = picture.channels() - 1;
        return grid(picture, pixel -> -Math.log(1 - Math.min(unit(picture, pixel, alpha), OPAQUE)));
    }

    /** Returns the means of the colours, 0 to 1. */
    static VoxelGrid greys(Picture picture) {
        int colours = picture.channels() < 3 ? 1 : 3;
        return grid(picture, pixel -> {
            double sum = 0;
            for (int channel = 0; channel < colours; channel++) {
                sum += unit(picture, pixel, channel);
            }
            return sum / colours;
        });
    }

    private static double unit(Picture picture, int pixel, int channel) {
        int value = picture.sample(pixel % picture.width(), pixel / picture.width(), channel);
        return value / (picture.bitsPerChannel() == 8 ? 255.0 : 65535.0);
    }

    private static VoxelGrid grid(Picture picture, IntToDoubleFunction valueOfPixel) {
        float[] values = new float[picture.width() * picture.height()];
        for (int pixel = 0; pixel < values.length; pixel++) {
            values[pixel] = (float) valueOfPixel.applyAsDouble(pixel);
        }
        double half = TILE_METRES / 2;
        return new VoxelGrid(picture.width(), 1, picture.height(), new Aabb(-half, 0, -half, half, 1, half), values);
    }
}
