package nephele.engine.cloud.field;

import java.util.function.IntToDoubleFunction;
import nephele.engine.asset.Picture;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.math.Aabb;

/** Pictures of clouds as seen from above, with −z at the top, as one layer of voxels. */
final class CloudPicture {
    /** Edge of the square that a picture covers in a layer, which repeats it. */
    static final double TILE_METRES = 10_000;

    /** The greatest alpha that counts; 1 would be an infinite optical depth. */
    private static final double OPAQUE = 254.5 / 255;

    private CloudPicture() {}

    static boolean hasAlpha(Picture picture) {
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
