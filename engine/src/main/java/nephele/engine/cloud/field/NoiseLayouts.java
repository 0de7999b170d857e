package nephele.engine.cloud.field;

import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.level.Cloud;

/**
 * The four noises of a cloud at one moment. Their periods are in rational proportions and their turns have rational
 * cosines, so that the whole pattern repeats after {@link #PERIOD_FEATURES} features along x and z; it does not appear
 * to, because no two of them repeat together before.
 *
 * @param shape billows of one feature
 * @param detail wisps and small billows
 * @param bodies clouds in plan
 * @param clusters of clouds in plan
 */
record NoiseLayouts(EvolvingNoise shape, EvolvingNoise detail, EvolvingNoise bodies, EvolvingNoise clusters) {
    /** Period of the pattern in features. */
    static final int PERIOD_FEATURES = 260 * CloudTables.SHAPE_CELLS;

    private static final double DETAIL_PERIODS = 5.0 / 33;
    private static final double BODY_PERIODS = 13.0 / 2;
    private static final double CLUSTER_PERIODS = 20;

    static NoiseLayouts of(Cloud.Density.Noise noise, CloudTables tables, double evolutionSeconds, double seconds) {
        double period = CloudTables.SHAPE_CELLS * noise.featureMetres();
        long seed = noise.seed();
        return new NoiseLayouts(
                new EvolvingNoise(tables.shape(), period, 1, 0, 4 * seed, generation(seconds, evolutionSeconds)),
                new EvolvingNoise(
                        tables.detail(),
                        period * DETAIL_PERIODS,
                        1,
                        0,
                        4 * seed + 1,
                        generation(seconds, evolutionSeconds / 2)),
                new EvolvingNoise(
                        tables.plan(),
                        period * BODY_PERIODS,
                        3.0 / 5,
                        4.0 / 5,
                        4 * seed + 2,
                        generation(seconds, evolutionSeconds * 4)),
                new EvolvingNoise(
                        tables.plan(),
                        period * CLUSTER_PERIODS,
                        5.0 / 13,
                        12.0 / 13,
                        4 * seed + 3,
                        generation(seconds, evolutionSeconds * 16)));
    }

    /** Returns the generation at a time, a multiple of the generations' number nearer to 0 than that. */
    private static double generation(double seconds, double secondsEach) {
        double all = EvolvingNoise.GENERATIONS * secondsEach;
        if (!(secondsEach > 0) || !Double.isFinite(seconds)) {
            return 0;
        }
        double into = seconds % all;
        return (into < 0 ? into + all : into) / secondsEach;
    }
}
