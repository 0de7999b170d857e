package nephele.engine.cloud.field;

import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Hash64;
import nephele.engine.math.Ray;
import nephele.engine.math.SeededNoise;

/**
 * A medium of four octaves of value noise. With n their sum, weighted by ½ for each next octave and scaled to 0 to 1,
 * the density is (n − (1 − coverage)) / coverage where that is positive. Hard faces at the bounds.
 */
public final class NoiseField implements ExtinctionField {
    private static final int OCTAVES = 4;

    /** Octaves that bounds are computed of; each has eight times the lattice points of the one before. */
    private static final int BOUNDED_OCTAVES = 2;

    /** Most cells of a walk across the shortest edge; noise finer than that has one bound for all. */
    private static final double MOST_CELLS = 256;

    private final Aabb bounds;
    private final double featureMetres;
    private final double coverage;
    private final double extinctionPerMetre;
    private final SeededNoise[] octaves = new SeededNoise[OCTAVES];
    private final CellLattice lattice;
    private final boolean bounded;

    /**
     * @param bounds may be infinite in x and z
     * @param featureMetres cell of the coarsest octave
     * @param coverage 0 to 1: 0 gives no cloud
     */
    public NoiseField(Aabb bounds, long seed, double featureMetres, double coverage, double extinctionPerMetre) {
        this.bounds = bounds;
        this.featureMetres = featureMetres;
        this.coverage = coverage;
        this.extinctionPerMetre = extinctionPerMetre;
        for (int octave = 0; octave < OCTAVES; octave++) {
            octaves[octave] = new SeededNoise((int) Hash64.combine(seed, octave));
        }
        double shortest = Math.min(
                bounds.maxY() - bounds.minY(), Math.min(bounds.maxX() - bounds.minX(), bounds.maxZ() - bounds.minZ()));
        bounded = shortest / featureMetres <= MOST_CELLS;
        double cell = bounded ? featureMetres : shortest / MOST_CELLS;
        lattice = new CellLattice(0, 0, 0, cell, cell, cell);
    }

    @Override
    public double perMetre(double x, double y, double z) {
        if (!bounds.contains(x, y, z)) {
            return 0;
        }
        double sum = 0;
        double weights = 0;
        for (int octave = 0; octave < OCTAVES; octave++) {
            double scale = (1 << octave) / featureMetres;
            double weight = weight(octave);
            sum += weight * octaves[octave].at(x * scale, y * scale, z * scale);
            weights += weight;
        }
        return extinction(sum / weights);
    }

    private static double weight(int octave) {
        return 1.0 / (1 << octave);
    }

    private double extinction(double noise) {
        return coverage > 0 ? extinctionPerMetre * Math.max(0, (noise - (1 - coverage)) / coverage) : 0;
    }

    /** Bounds the first octaves by their lattice points and takes the others as 1. */
    private double bound(long i, long j, long k) {
        double sum = 0;
        double weights = 0;
        for (int octave = 0; octave < OCTAVES; octave++) {
            sum += weight(octave) * (bounded && octave < BOUNDED_OCTAVES ? greatest(octave, i, j, k) : 1);
            weights += weight(octave);
        }
        return extinction(sum / weights);
    }

    private double greatest(int octave, long i, long j, long k) {
        int points = 1 << octave;
        double greatest = 0;
        for (int c = 0; c <= points; c++) {
            for (int b = 0; b <= points; b++) {
                for (int a = 0; a <= points; a++) {
                    double value = octaves[octave].unit(
                            (int) (i * points + a), (int) (j * points + b), (int) (k * points + c));
                    greatest = Math.max(greatest, value);
                }
            }
        }
        return greatest;
    }

    @Override
    public Aabb bounds() {
        return bounds;
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        return new CellWalk(ray, RaySpan.inBox(ray, bounds, fromMetres, toMetres), lattice, this::bound);
    }
}
