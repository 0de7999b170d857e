package nephele.engine.cloud.noise;

import nephele.engine.math.Hash64;
import nephele.engine.work.SwingThread;

/**
 * The tables of one seed. Billows follow Schneider 2015, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn":
 * gradient noise dilated by cellular noise.
 *
 * @param shape billows in space, {@link #SHAPE_CELLS} to an edge
 * @param detail three octaves of the distance to the nearest of random points, {@link #DETAIL_CELLS} to an edge
 * @param plan billows in one layer, {@link #PLAN_CELLS} to an edge
 */
public record CloudTables(PeriodicTable shape, PeriodicTable detail, PeriodicTable plan) {
    public static final int SHAPE_CELLS = 4;
    public static final int DETAIL_CELLS = 2;
    public static final int PLAN_CELLS = 8;

    private static final int SHAPE_SIZE = 64;
    private static final int DETAIL_SIZE = 32;
    private static final int PLAN_SIZE = 256;

    /** Makes the tables of a seed; equal seeds give equal tables on every machine. */
    public static CloudTables of(long seed) {
        SwingThread.refuse("the noise of clouds");
        return new CloudTables(
                billows(seed, SHAPE_SIZE, SHAPE_SIZE, SHAPE_CELLS),
                detail(Hash64.combine(seed, 1)),
                billows(Hash64.combine(seed, 2), PLAN_SIZE, 1, PLAN_CELLS));
    }

    private static PeriodicTable billows(long seed, int size, int layers, int cells) {
        float[] gradient = new float[size * layers * size];
        float[] cellular = new float[gradient.length];
        for (int octave = 0; octave < 3; octave++) {
            var noise = new PeriodicNoise(size, layers, (int) Hash64.combine(seed, octave));
            noise.addGradient(gradient, cells << octave, weight(octave));
            noise.addCellular(cellular, cells << octave, weight(octave));
        }
        for (int i = 0; i < gradient.length; i++) {
            float soft = 0.5f + 0.5f * gradient[i];
            gradient[i] = 1 - cellular[i] * (1 - soft);
        }
        return PeriodicTable.ranked(size, gradient);
    }

    private static float weight(int octave) {
        return octave == 0 ? 0.625f : 0.5f / (1 << octave);
    }

    private static PeriodicTable detail(long seed) {
        float[] sum = new float[DETAIL_SIZE * DETAIL_SIZE * DETAIL_SIZE];
        for (int octave = 0; octave < 3; octave++) {
            new PeriodicNoise(DETAIL_SIZE, DETAIL_SIZE, (int) Hash64.combine(seed, octave))
                    .addCellular(sum, DETAIL_CELLS << octave, weight(octave));
        }
        return PeriodicTable.ranked(DETAIL_SIZE, sum);
    }
}
