package nephele.engine.cloud.cells;

import java.util.stream.IntStream;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.math.Aabb;

/**
 * A field sampled at the centres of cells, relative to the greatest value, and the distance of each cell to the nearest
 * one that has any extinction. Between centres it is interpolated. Immutable.
 */
public final class DensityCells {
    /** Distances are counted up to here, in cells. */
    public static final int FARTHEST = 32;

    private static final int MOST_SAMPLES = 4;

    private final CellBox cells;
    private final float[] densities;
    private final byte[] distances;
    private final double greatestPerMetre;

    private DensityCells(CellBox cells, float[] perMetre, double greatestPerMetre, float[] occupied) {
        this.cells = cells;
        this.greatestPerMetre = greatestPerMetre;
        densities = perMetre;
        for (int at = 0; at < perMetre.length && greatestPerMetre > 0; at++) {
            densities[at] = Math.round(255 * Math.min(1, perMetre[at] / greatestPerMetre)) / 255f;
        }
        distances = EmptyDistance.of(cells, occupied == null ? densities : occupied, FARTHEST);
    }

    /** An upper bound of a field's extinction in a box. */
    @FunctionalInterface
    public interface Bound {
        double perMetre(Aabb box);
    }

    /**
     * How a field is sampled.
     *
     * @param bound tells where the field can have any extinction; {@code null} if the samples tell it
     * @param finestMetres size of what must not be missed between two samples
     * @param greatestPerMetre what density 1 stands for; 0 for the greatest sample
     */
    public record Sampling(Bound bound, double finestMetres, double greatestPerMetre) {
        /** Takes one sample a cell, and density 1 for the greatest. */
        public static final Sampling PLAIN = new Sampling(null, Double.POSITIVE_INFINITY, 0);
    }

    /** Samples a field on all processors. */
    public static DensityCells of(ExtinctionField field, CellBox cells, Sampling sampling) {
        float[] sampled = sampled(field, cells, sampling.finestMetres());
        double scale = sampling.greatestPerMetre();
        if (!(scale > 0)) {
            for (float value : sampled) {
                scale = Math.max(scale, value);
            }
        }
        return new DensityCells(
                cells, sampled, scale, sampling.bound() == null ? null : occupied(cells, sampling.bound()));
    }

    private static int perEdge(double edge, double finestMetres) {
        return (int) Math.max(1, Math.min(MOST_SAMPLES, Math.ceil(edge / finestMetres)));
    }

    private static float[] occupied(CellBox cells, Bound bound) {
        float[] occupied = new float[cells.count()];
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    occupied[cells.index(i, j, k)] = (float) bound.perMetre(cells.cell(i, j, k));
                }
            }
        });
        return occupied;
    }

    private static float[] sampled(ExtinctionField field, CellBox cells, double finestMetres) {
        float[] perMetre = new float[cells.count()];
        int across = perEdge(Math.max(cells.sizeX(), cells.sizeZ()), finestMetres);
        int up = perEdge(cells.sizeY(), finestMetres);
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    perMetre[cells.index(i, j, k)] = (float) mean(field, cells, across, up, i, j, k);
                }
            }
        });
        return perMetre;
    }

    private static double mean(ExtinctionField field, CellBox cells, int across, int up, int i, int j, int k) {
        double sum = 0;
        int count = across * across * up;
        for (int n = 0; n < count; n++) {
            double x = cells.centreX(i) + offset(n % across, across) * cells.sizeX();
            double y = cells.centreY(j) + offset(n / across / across, up) * cells.sizeY();
            double z = cells.centreZ(k) + offset(n / across % across, across) * cells.sizeZ();
            sum += field.perMetre(x, y, z);
        }
        return sum / count;
    }

    private static double offset(int index, int perEdge) {
        return (index + 0.5) / perEdge - 0.5;
    }

    public CellBox cells() {
        return cells;
    }

    /** Returns true if there is no extinction anywhere. */
    public boolean isEmpty() {
        return greatestPerMetre == 0;
    }

    /** Returns the extinction that density 1 stands for. */
    public double greatestPerMetre() {
        return greatestPerMetre;
    }

    float[] densities() {
        return densities;
    }

    byte[] distances() {
        return distances;
    }
}
