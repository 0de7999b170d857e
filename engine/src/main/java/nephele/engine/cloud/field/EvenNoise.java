package nephele.engine.cloud.field;

import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.level.Cloud;

/**
 * Noise that is the same at all heights: with n its billows, the density is (n − (1 − coverage)) / coverage, less what
 * detail erodes, where that is positive, times the coverage map. Without erosion and map its mean over space is half the
 * coverage.
 */
final class EvenNoise implements NoiseDensity {
    private static final double EROSION = 0.7;

    private final EvolvingNoise shape;
    private final EvolvingNoise detail;
    private final double coverage;
    private final PlanMap map;
    private final double erosion;

    /** @param map {@code null} for none */
    EvenNoise(Cloud.Density.Noise noise, NoiseLayouts noises, PlanMap map) {
        shape = noises.shape();
        detail = noises.detail();
        coverage = noise.coverage();
        this.map = map;
        erosion = EROSION * noise.erosion();
    }

    @Override
    public double at(double x, double y, double z) {
        double density = dense(shape.at(x, y, z));
        if (density > 0 && erosion > 0) {
            density = Math.max(0, density - erosion * detail.at(x, y, z));
        }
        return map == null || !(density > 0) ? density : density * map.at(x, z);
    }

    @Override
    public boolean isEmpty() {
        return coverage == 0 || map != null && map.isBlack();
    }

    private double dense(double noise) {
        return coverage > 0 ? Math.max(0, 1 - (1 - noise) / coverage) : 0;
    }

    @Override
    public double greatest(double x, double y, double z, double halfX, double halfY, double halfZ) {
        double density = dense(shape.greatest(x, y, z, halfX, halfY, halfZ));
        return map == null ? density : density * map.greatest(x - halfX, z - halfZ, x + halfX, z + halfZ);
    }
}
