package nephele.lab.prove.cloud;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.math.Hash64;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.VolumeTracer;

/**
 * A part of the picture of a case, traced, with the variance of each value from independent batches.
 */
final class TracedTile {
    private static final int BATCHES = 32;

    /** Pixels on each side of one over which its variance is averaged. */
    private static final int SMOOTHED = 2;

    private final ReferenceCase scene;
    private final VolumeTracer tracer;
    private final CloudMedia media;
    private final int left;
    private final int bottom;
    private final int width;
    private final int height;
    private final double[] mean;
    private final double[] variance;
    private final boolean[] meets;

    /** Starts with the pixels of a rectangle, {@code bottom} counted from below; {@link #trace} fills them. */
    TracedTile(ReferenceCase scene, int left, int bottom, int width, int height) {
        this.scene = scene;
        this.left = left;
        this.bottom = bottom;
        this.width = width;
        this.height = height;
        media = new CloudMedia(List.of(scene.medium()));
        tracer = new VolumeTracer(media, scene.light());
        mean = new double[3 * width * height];
        variance = new double[mean.length];
        meets = new boolean[width * height];
    }

    /** Traces all pixels on all processors. @return this */
    TracedTile trace(int samplesPerBatch, long seed) {
        IntStream.range(0, meets.length).parallel().forEach(pixel -> pixel(pixel, samplesPerBatch, seed));
        return this;
    }

    private void pixel(int pixel, int samplesPerBatch, long seed) {
        var random = new SplittableRandom(Hash64.combine(seed, inPicture(pixel)));
        double[] sum = new double[3];
        double[] squares = new double[3];
        for (int batch = 0; batch < BATCHES; batch++) {
            Vec3 radiance = Vec3.ZERO;
            for (int n = 0; n < samplesPerBatch; n++) {
                radiance = radiance.plus(sample(pixel, random));
            }
            double[] rgb = {radiance.x(), radiance.y(), radiance.z()};
            for (int channel = 0; channel < 3; channel++) {
                double value = rgb[channel] / samplesPerBatch;
                sum[channel] += value;
                squares[channel] += value * value;
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            double average = sum[channel] / BATCHES;
            mean[3 * pixel + channel] = average;
            variance[3 * pixel + channel] = Math.max(0, squares[channel] / BATCHES - average * average) / (BATCHES - 1);
        }
    }

    private Vec3 sample(int pixel, SplittableRandom random) {
        double column = left + pixel % width + random.nextDouble();
        double row = bottom + pixel / width + random.nextDouble();
        Ray ray = scene.ray(column, row);
        var met = media.collision(ray, 0, Double.POSITIVE_INFINITY, random);
        meets[pixel] |= met != null;
        return met == null ? scene.light().skyRadiance() : tracer.radianceAt(met, ray, random);
    }

    int pixels() {
        return meets.length;
    }

    /** Returns the index of one of this tile's pixels in the whole picture. */
    int inPicture(int pixel) {
        return (bottom + pixel / width) * scene.radiance().width() + left + pixel % width;
    }

    /** Returns true if a path met the cloud at its first flight. */
    boolean meetsCloud(int pixel) {
        return meets[pixel];
    }

    double mean(int pixel, int channel) {
        return mean[3 * pixel + channel];
    }

    /** Returns the variance of {@link #mean}, averaged over 5 by 5 pixels. */
    double variance(int pixel, int channel) {
        double sum = 0;
        int count = 0;
        int x = pixel % width;
        int y = pixel / width;
        for (int j = Math.max(0, y - SMOOTHED); j <= Math.min(height - 1, y + SMOOTHED); j++) {
            for (int i = Math.max(0, x - SMOOTHED); i <= Math.min(width - 1, x + SMOOTHED); i++) {
                sum += variance[3 * (j * width + i) + channel];
                count++;
            }
        }
        return sum / count;
    }
}
