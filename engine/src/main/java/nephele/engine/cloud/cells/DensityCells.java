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

    private static final int MOST_SAMPLES = 3;

    private final CellBox cells;
    private final float[] densities;
    private final byte[] distances;
    private final double greatestPerMetre;

    private DensityCells(CellBox cells, float[] densities, byte[] distances, double greatestPerMetre) {
        this.cells = cells;
        this.densities = densities;
        this.distances = distances;
        this.greatestPerMetre = greatestPerMetre;
    }

    private DensityCells(CellBox cells, float[] perMetre, double greatestPerMetre, float[] occupied) {
        this.cells = cells;
        this.greatestPerMetre = greatestPerMetre;
        densities = perMetre;
        for (int at = 0; at < perMetre.length && greatestPerMetre > 0; at++) {
            densities[at] = Math.round(255 * Math.min(1, perMetre[at] / greatestPerMetre)) / 255f;
        }
        distances = EmptyDistance.of(cells, occupied == null ? densities : occupied, FARTHEST);
    }

    /**
     * How a field is sampled.
     *
     * @param finestMetres size of what must not be missed between two samples
     * @param greatestPerMetre what density 1 stands for; 0 for the greatest sample
     */
    public record Sampling(double finestMetres, double greatestPerMetre) {
        /** Takes one sample a cell, and density 1 for the greatest. */
        public static final Sampling PLAIN = new Sampling(Double.POSITIVE_INFINITY, 0);
    }

    /** A field whose columns are made of bodies in plan, by their depth inside of one. */
    public interface Columns {
        /** Returns the depth of a column. */
        double depth(double x, double z);

        /** Returns an upper bound of the depths in a rectangle, given by its centre and half its sides. */
        double greatestDepth(double x, double z, double halfX, double halfZ);

        /** Returns the least depth at which there can be extinction between two heights. */
        double leastDepth(double fromY, double toY);

        /** Returns the extinction at a point of a column. */
        double perMetre(double depth, double x, double y, double z);
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
        return new DensityCells(cells, sampled, scale, null);
    }

    /** Samples columns on all processors; they tell, too, where there can be any extinction. */
    public static DensityCells of(Columns field, CellBox cells, Sampling sampling) {
        float[] perMetre = new float[cells.count()];
        float[] occupied = new float[cells.count()];
        double[] least = new double[cells.ny()];
        for (int j = 0; j < cells.ny(); j++) {
            Aabb row = cells.cell(0, j, 0);
            least[j] = field.leastDepth(row.minY(), row.maxY());
        }
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            for (int i = 0; i < cells.nx(); i++) {
                double greatest =
                        field.greatestDepth(cells.centreX(i), cells.centreZ(k), cells.sizeX() / 2, cells.sizeZ() / 2);
                for (int j = 0; j < cells.ny(); j++) {
                    occupied[cells.index(i, j, k)] = greatest > least[j] ? 1 : 0;
                }
                addColumn(field, cells, sampling.finestMetres(), least, perMetre, i, k);
            }
        });
        return new DensityCells(cells, perMetre, sampling.greatestPerMetre(), occupied);
    }

    private static void addColumn(
            Columns field, CellBox cells, double finestMetres, double[] least, float[] perMetre, int i, int k) {
        int across = perEdge(Math.max(cells.sizeX(), cells.sizeZ()), finestMetres);
        int up = perEdge(cells.sizeY(), finestMetres);
        for (int n = 0; n < across * across; n++) {
            double x = cells.centreX(i) + offset(n % across, across) * cells.sizeX();
            double z = cells.centreZ(k) + offset(n / across, across) * cells.sizeZ();
            double depth = field.depth(x, z);
            for (int j = 0; j < cells.ny(); j++) {
                if (depth > least[j]) {
                    double sum = 0;
                    for (int m = 0; m < up; m++) {
                        double y = cells.centreY(j) + offset(m, up) * cells.sizeY();
                        sum += field.perMetre(depth, x, y, z);
                    }
                    perMetre[cells.index(i, j, k)] += sum / (up * across * across);
                }
            }
        }
    }

    private static int perEdge(double edge, double finestMetres) {
        return (int) Math.max(1, Math.min(MOST_SAMPLES, Math.ceil(edge / finestMetres)));
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

    /** Returns the same densities with a share of the extinction. */
    public DensityCells scaled(double share) {
        return share == 1 ? this : new DensityCells(cells, densities, distances, share * greatestPerMetre);
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

    /** Returns the density of a cell, 0 to 1. */
    public double density(int i, int j, int k) {
        return densities[cells.index(i, j, k)];
    }

    /** Returns the mean optical depth of its columns. */
    public double meanDepth() {
        double sum = 0;
        for (float density : densities) {
            sum += density;
        }
        return greatestPerMetre * (cells.box().maxY() - cells.box().minY()) * sum / cells.count();
    }

    float[] densities() {
        return densities;
    }

    byte[] distances() {
        return distances;
    }
}
