package nephele.engine.cloud.field;

import nephele.engine.cloud.noise.EvolvingNoise;

/**
 * Noise that is the same at all heights: with n its billows, the density is (n − (1 − coverage)) / coverage, less what
 * detail erodes, where that is positive. Its mean over space is half the coverage.
 */
final class EvenNoise implements NoiseDensity {
    private static final double EROSION = 0.7;

    private final EvolvingNoise shape;
    private final EvolvingNoise detail;
    private final Coverage coverage;
    private final double erosion;

    /** @param erosion 0 to 1 */
    EvenNoise(NoiseLayouts noises, Coverage coverage, double erosion) {
        shape = noises.shape();
        detail = noises.detail();
        this.coverage = coverage;
        this.erosion = EROSION * erosion;
    }

    @Override
    public double at(double x, double y, double z) {
        double density = density(shape.at(x, y, z), coverage.at(x, z));
        return density > 0 && erosion > 0 ? Math.max(0, density - erosion * detail.at(x, y, z)) : density;
    }

    private static double density(double noise, double covered) {
        return covered > 0 ? Math.max(0, 1 - (1 - noise) / covered) : 0;
    }

    @Override
    public double greatest(double x, double y, double z, double halfX, double halfY, double halfZ) {
        return density(shape.greatest(x, y, z, halfX, halfY, halfZ), coverage.greatest(x, z, halfX, halfZ));
    }
}
