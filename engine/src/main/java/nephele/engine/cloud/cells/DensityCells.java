package nephele.engine.cloud.cells;

import java.util.ArrayList;
import java.util.List;
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

    private DensityCells(CellBox cells, float[] perMetre, float greatestPerMetre, float[] occupied) {
        this.cells = cells;
        this.greatestPerMetre = greatestPerMetre;
        densities = perMetre;
        for (int at = 0; at < perMetre.length && greatestPerMetre > 0; at++) {
            densities[at] = Math.round(255 * perMetre[at] / greatestPerMetre) / 255f;
        }
        distances = EmptyDistance.of(cells, occupied == null ? densities : occupied, FARTHEST);
    }

    /** An upper bound of a field's extinction in a box. */
    @FunctionalInterface
    public interface Bound {
        double perMetre(Aabb box);
    }

    /**
     * Samples a field on all processors.
     *
     * @param boxes of cells that share one scale of densities
     * @param bound tells where the field can have any extinction; {@code null} if the samples tell it
     * @param finestMetres size of what must not be missed between two samples
     */
    public static List<DensityCells> of(ExtinctionField field, List<CellBox> boxes, Bound bound, double finestMetres) {
        List<float[]> sampled = boxes.stream()
                .map(cells -> sampled(field, cells, perEdge(cells, finestMetres)))
                .toList();
        float most = 0;
        for (float[] values : sampled) {
            for (float value : values) {
                most = Math.max(most, value);
            }
        }
        List<DensityCells> all = new ArrayList<>();
        for (int i = 0; i < boxes.size(); i++) {
            float[] occupied = bound == null ? null : occupied(boxes.get(i), bound);
            all.add(new DensityCells(boxes.get(i), sampled.get(i), most, occupied));
        }
        return all;
    }

    private static int perEdge(CellBox cells, double finestMetres) {
        return (int) Math.max(1, Math.min(MOST_SAMPLES, Math.ceil(cells.sizeX() / finestMetres)));
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

    private static float[] sampled(ExtinctionField field, CellBox cells, int perEdge) {
        float[] perMetre = new float[cells.count()];
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    perMetre[cells.index(i, j, k)] = (float) mean(field, cells, perEdge, i, j, k);
                }
            }
        });
        return perMetre;
    }

    private static double mean(ExtinctionField field, CellBox cells, int perEdge, int i, int j, int k) {
        double sum = 0;
        for (int n = 0; n < perEdge * perEdge * perEdge; n++) {
            double x = cells.centreX(i) + offset(n % perEdge, perEdge) * cells.sizeX();
            double y = cells.centreY(j) + offset(n / perEdge % perEdge, perEdge) * cells.sizeY();
            double z = cells.centreZ(k) + offset(n / perEdge / perEdge, perEdge) * cells.sizeZ();
            sum += field.perMetre(x, y, z);
        }
        return sum / (perEdge * perEdge * perEdge);
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
