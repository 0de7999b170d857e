package nephele.engine.reference;

import nephele.engine.math.BitHash;
import nephele.engine.math.SeededNoise;

/**
 * Points of the unit hypercube that fill it evenly: Roberts' R sequence ("The Unreasonable Effectiveness of Quasirandom
 * Sequences", 2018) in four dimensions, shifted for each pixel by its own offset (Cranley and Patterson 1976). A value of
 * pixel, sample and seed, whoever asks and when.
 */
final class SampleSequence {
    static final int DIMENSIONS = 4;

    /** The positive root of x⁵ = x + 1, whose powers are the least rational steps in four dimensions. */
    private static final double STEP_ROOT = 1.1673039782614187;

    private final SeededNoise noise;
    private final double[] steps = new double[DIMENSIONS];

    SampleSequence(long seed) {
        noise = new SeededNoise((int) BitHash.join(0, seed));
        double step = 1;
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            step /= STEP_ROOT;
            steps[dimension] = step;
        }
    }

    /** Writes the point of a sample, each coordinate in [0, 1). */
    void point(int column, int row, int sample, double[] point) {
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            double at = noise.unit(column, row, dimension) + (sample + 1) * steps[dimension];
            point[dimension] = at - Math.floor(at);
        }
    }
}
