package nephele.engine.cloud.noise;

import nephele.engine.math.Hash64;

/**
 * The tables of one seed.
 *
 * @param shape billows, after Schneider 2015, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn": gradient
 *     noise dilated by cellular noise, {@link #SHAPE_CELLS} billows to an edge
 * @param detail three octaves of the distance to the nearest of random points, {@link #DETAIL_CELLS} to an edge
 */
public record CloudTables(PeriodicTable shape, PeriodicTable detail) {
    /** Largest billows along an edge of the shape table. */
    public static final int SHAPE_CELLS = 4;

    /** Largest cells along an edge of the detail table. */
    public static final int DETAIL_CELLS = 2;

    private static final int SHAPE_SIZE = 64;
    private static final int DETAIL_SIZE = 32;

    /** Makes the tables of a seed; equal seeds give equal tables on every machine. */
    public static CloudTables of(long seed) {
        return new CloudTables(shape(seed), detail(seed));
    }

    private static PeriodicTable shape(long seed) {
        int count = SHAPE_SIZE * SHAPE_SIZE * SHAPE_SIZE;
        float[] gradient = new float[count];
        float[] cellular = new float[count];
        for (int octave = 0; octave < 3; octave++) {
            var noise = new PeriodicNoise(SHAPE_SIZE, (int) Hash64.combine(seed, octave));
            noise.addGradient(gradient, SHAPE_CELLS << octave, 0.5f / (1 << octave));
            noise.addCellular(cellular, SHAPE_CELLS << octave, octave == 0 ? 0.625f : 0.5f / (1 << octave));
        }
        float[] dilated = new float[count];
        for (int i = 0; i < count; i++) {
            float soft = 0.5f + 0.5f * gradient[i];
            float round = 1 - cellular[i];
            dilated[i] = round + soft * (1 - round);
        }
        return PeriodicTable.ranked(SHAPE_SIZE, dilated);
    }

    private static PeriodicTable detail(long seed) {
        float[] sum = new float[DETAIL_SIZE * DETAIL_SIZE * DETAIL_SIZE];
        for (int octave = 0; octave < 3; octave++) {
            var noise = new PeriodicNoise(DETAIL_SIZE, (int) Hash64.combine(seed, 16 + octave));
            noise.addCellular(sum, DETAIL_CELLS << octave, octave == 0 ? 0.625f : 0.5f / (1 << octave));
        }
        return PeriodicTable.ranked(DETAIL_SIZE, sum);
    }
}
