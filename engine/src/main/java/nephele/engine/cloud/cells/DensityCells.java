package nephele.engine.cloud.cells;

import java.util.Arrays;
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
    private final double wholePerMetre;

    private DensityCells(
            CellBox cells, float[] densities, byte[] distances, double greatestPerMetre, double wholePerMetre) {
        this.cells = cells;
        this.densities = densities;
        this.distances = distances;
        this.greatestPerMetre = greatestPerMetre;
        this.wholePerMetre = wholePerMetre;
    }

    private DensityCells(CellBox cells, float[] perMetre, double greatestPerMetre, float[] occupied) {
        this.cells = cells;
        this.greatestPerMetre = greatestPerMetre;
        wholePerMetre = greatestPerMetre;
        densities = perMetre;
        for (int at = 0; at < perMetre.length && greatestPerMetre > 0; at++) {
            densities[at] = Math.round(255 * Math.min(1, perMetre[at] / greatestPerMetre)) / 255f;
        }
        distances = emptyDistances(cells, occupied == null ? densities : occupied, FARTHEST);
    }

    /** A field whose columns are made of bodies in plan, by their depth inside of one; by default all are inside. */
    public interface Columns {
        /** Returns the depth of a column. */
        default double depth(double x, double z) {
            return 1;
        }

        /** Returns an upper bound of the depths in a rectangle, given by its centre and half its sides. */
        default double greatestDepth(double x, double z, double halfX, double halfZ) {
            return 1;
        }

        /** Returns the least depth at which there can be extinction between two heights. */
        default double leastDepth(double fromY, double toY) {
            return 0;
        }

        /** Returns the extinction at a point of a column. */
        double perMetre(double depth, double x, double y, double z);
    }

    /** Samples a field on all processors, once a cell, with density 1 for the greatest sample. */
    public static DensityCells of(ExtinctionField field, CellBox cells) {
        return of(field, cells, Double.POSITIVE_INFINITY, 0);
    }

    /**
     * Samples a field on all processors.
     *
     * @param finestMetres size of what must not be missed between two samples
     * @param greatestPerMetre what density 1 stands for; 0 for the greatest sample
     */
    public static DensityCells of(ExtinctionField field, CellBox cells, double finestMetres, double greatestPerMetre) {
        float[] sampled = sampled(field, cells, finestMetres);
        double scale = greatestPerMetre;
        if (!(scale > 0)) {
            for (float value : sampled) {
                scale = Math.max(scale, value);
            }
        }
        return new DensityCells(cells, sampled, scale, null);
    }

    /** Samples columns on all processors; they tell, too, where there can be any extinction. */
    public static DensityCells of(Columns field, CellBox cells, double finestMetres, double greatestPerMetre) {
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
                addColumn(field, cells, finestMetres, least, perMetre, i, k);
            }
        });
        return new DensityCells(cells, perMetre, greatestPerMetre, occupied);
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

    /** Returns the same densities with a fraction of the extinction. */
    public DensityCells scaled(double fraction) {
        return fraction == 1
                ? this
                : new DensityCells(cells, densities, distances, fraction * greatestPerMetre, wholePerMetre);
    }

    public CellBox cells() {
        return cells;
    }

    /** Returns the extinction that density 1 stands for. */
    public double greatestPerMetre() {
        return greatestPerMetre;
    }

    /** Returns the extinction that density 1 stands for before it is scaled. */
    public double wholePerMetre() {
        return wholePerMetre;
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

    /**
     * Returns the distance of each cell to the nearest one with a density, along the greatest coordinate (Chebyshev's distance): 0 where linear filtering at any point of the cell may see a density, then in
     * cells, at most {@code farthest}. What lies beside the box counts as density.
     */
    private static byte[] emptyDistances(CellBox cells, float[] densities, int farthest) {
        byte[] distances = new byte[densities.length];
        Arrays.fill(distances, (byte) farthest);
        int nx = cells.nx();
        int layer = nx * cells.ny();
        for (int at = 0; at < densities.length; at++) {
            if (densities[at] > 0) {
                distances[at] = 0;
            } else if (isAtSide(at % nx, nx) || isAtSide(at / layer, cells.nz())) {
                distances[at] = 1;
            }
        }
        // Two sweeps there and back: the distance of a cell is one more than the least of its 26 neighbours'.
        sweep(distances, cells, -1);
        sweep(distances, cells, 1);
        for (int at = 0; at < distances.length; at++) {
            distances[at] = (byte) Math.max(0, distances[at] - 1);
        }
        return distances;
    }

    private static boolean isAtSide(int index, int count) {
        return index == 0 || index == count - 1;
    }

    /** Regards the thirteen neighbours of each cell that lie on one side: those that the sweep has passed already. */
    private static void sweep(byte[] distances, CellBox cells, int side) {
        int[] steps = new int[13];
        for (int n = 0; n < steps.length; n++) {
            steps[n] = cells.index(dx(n, side), dy(n, side), dz(n, side));
        }
        for (int n = 0; n < distances.length; n++) {
            int at = side < 0 ? n : distances.length - 1 - n;
            if (distances[at] > 0) {
                distances[at] = (byte) nearer(distances, cells, at, steps, side);
            }
        }
    }

    private static int nearer(byte[] distances, CellBox cells, int at, int[] steps, int side) {
        int i = at % cells.nx();
        int j = at / cells.nx() % cells.ny();
        int k = at / cells.nx() / cells.ny();
        boolean isInside = !isAtSide(i, cells.nx()) && !isAtSide(j, cells.ny()) && !isAtSide(k, cells.nz());
        int least = distances[at];
        for (int n = 0; n < steps.length; n++) {
            if (isInside || hasNeighbour(cells, i + dx(n, side), j + dy(n, side), k + dz(n, side))) {
                least = Math.min(least, distances[at + steps[n]] + 1);
            }
        }
        return least;
    }

    private static int dx(int n, int side) {
        return n < 9 ? n % 3 - 1 : n < 12 ? n - 10 : side;
    }

    private static int dy(int n, int side) {
        return n < 9 ? n / 3 - 1 : n < 12 ? side : 0;
    }

    private static int dz(int n, int side) {
        return n < 9 ? side : 0;
    }

    private static boolean hasNeighbour(CellBox cells, int i, int j, int k) {
        return within(i, cells.nx()) && within(j, cells.ny()) && within(k, cells.nz());
    }

    private static boolean within(int index, int count) {
        return index >= 0 && index < count;
    }
}
