package nephele.workshop.prove.cloud;

import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.tile.PixelTiles;
import nephele.engine.reference.tile.TilePixels;
import nephele.engine.reference.tile.TiledPicture;

/** A part of the picture of a case, traced, and its differences from the reference. */
final class TracedArea {
    private static final double MOST_SIGMAS = 5;

    /** Difference from the sky by which a pixel shows the cloud; more than the rounding of either picture. */
    private static final double LEAST_OF_CLOUD = 1e-6;

    private final ReferenceCase scene;
    private final int left;
    private final int bottom;
    private final int width;
    private final float[] traced;
    private final float[] error;

    /**
     * @param left column of its first pixel in the whole picture
     * @param bottom row of it, counted from below
     */
    private TracedArea(ReferenceCase scene, int left, int bottom, TiledPicture picture) {
        this.scene = scene;
        this.left = left;
        this.bottom = bottom;
        width = picture.tiles().width();
        traced = picture.rgb();
        error = picture.standardError();
    }

    /** Traces the whole picture on all processors. */
    static TracedArea whole(ReferenceCase scene, int samples, long seed, DoubleConsumer progress) {
        return new TracedArea(
                scene,
                0,
                0,
                ReferencePicture.picture(scene.level(), scene.eye(), settings(scene, samples, seed), progress));
    }

    /** Traces one of the tiles of the picture; its error is smoothed within it. */
    static TracedArea tile(ReferenceCase scene, int tile, int samples, long seed) {
        TraceSettings settings = settings(scene, samples, seed);
        PixelTiles all = settings.tiles();
        TiledPicture alone = new TiledPicture(new PixelTiles(all.width(tile), all.height(tile)));
        ReferencePicture.tiles(
                scene.level(),
                scene.eye(),
                settings,
                IntStream.of(tile),
                pixels -> alone.put(new TilePixels(0, pixels.rgb(), pixels.variance())));
        return new TracedArea(scene, all.left(tile), all.bottom(tile), alone);
    }

    private static TraceSettings settings(ReferenceCase scene, int samples, long seed) {
        return new TraceSettings(
                scene.radiance().width(),
                scene.radiance().height(),
                samples,
                seed,
                Runtime.getRuntime().availableProcessors(),
                scene.transport());
    }

    private int pixels() {
        return traced.length / 3;
    }

    /** Returns the index of one of its pixels in the whole picture. */
    private int inWhole(int pixel) {
        return (bottom + pixel / width) * scene.radiance().width() + left + pixel % width;
    }

    /** Returns the difference of the mean radiance of a channel from the reference's, as a fraction of that. */
    double bias(int channel) {
        double expected = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            expected += reference(pixel, channel);
        }
        return difference(channel) / expected;
    }

    /** Returns the difference of the mean radiance of a channel in units of the joint standard error. */
    double biasSigmas(int channel) {
        double variance = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            variance += jointVariance(pixel, channel);
        }
        double difference = difference(channel);
        return difference == 0 ? 0 : difference / Math.sqrt(variance);
    }

    private double difference(int channel) {
        double sum = 0;
        double expected = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            sum += traced[3 * pixel + channel];
            expected += reference(pixel, channel);
        }
        return sum - expected;
    }

    /** Returns the number of pixels that show the cloud. */
    int cloudy() {
        int count = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            count += showsCloud(pixel) ? 1 : 0;
        }
        return count;
    }

    private boolean showsCloud(int pixel) {
        for (int channel = 0; channel < 3; channel++) {
            double sky = scene.sky().toVector().get(channel);
            if (Math.abs(traced[3 * pixel + channel] - sky) > LEAST_OF_CLOUD
                    || Math.abs(reference(pixel, channel) - sky) > LEAST_OF_CLOUD) {
                return true;
            }
        }
        return false;
    }

    /** Returns the number of pixels that show the cloud and differ by more than 5 standard errors in a channel. */
    int differing() {
        int count = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            count += showsCloud(pixel) && sigmas(pixel) > MOST_SIGMAS ? 1 : 0;
        }
        return count;
    }

    /** Returns the root of the mean squared difference in units of its standard error, over the pixels with cloud. */
    double spread() {
        double sum = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            if (showsCloud(pixel)) {
                double sigmas = sigmas(pixel, 0);
                sum += sigmas * sigmas;
            }
        }
        return Math.sqrt(sum / cloudy());
    }

    private double sigmas(int pixel) {
        double most = 0;
        for (int channel = 0; channel < 3; channel++) {
            most = Math.max(most, sigmas(pixel, channel));
        }
        return most;
    }

    /** Returns a difference in its standard error; 0 for equal values, which may have none. */
    private double sigmas(int pixel, int channel) {
        double difference = Math.abs(traced[3 * pixel + channel] - reference(pixel, channel));
        return difference == 0 ? 0 : difference / Math.sqrt(jointVariance(pixel, channel));
    }

    private double jointVariance(int pixel, int channel) {
        double ofReference = scene.error().rgb()[3 * inWhole(pixel) + channel];
        double ours = error[3 * pixel + channel];
        return ofReference * ofReference + ours * ours;
    }

    private double reference(int pixel, int channel) {
        return scene.radiance().rgb()[3 * inWhole(pixel) + channel];
    }
}
