package nephele.engine.cloud.field;

import java.util.Arrays;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.math.Aabb;

/** The greatest extinction in coarse cells of a grid: the maximum over the voxels that influence the cell. */
final class VoxelMaxima implements CellWalk.Bound {
    /** Voxels along the edge of a cell. More cells cost steps of a ray, fewer cost null collisions. */
    private static final int VOXELS = 4;

    private final int columns;
    private final int layers;
    private final int rows;
    private final double[] maxima;
    private final GridAxis.Edge sides;

    private VoxelMaxima(VoxelGrid grid, GridAxis.Edge sides) {
        columns = cells(grid.nx());
        layers = cells(grid.ny());
        rows = cells(grid.nz());
        maxima = new double[columns * layers * rows];
        this.sides = sides;
    }

    static VoxelMaxima of(VoxelGrid grid, double extinctionPerMetre, GridAxis.Edge sides) {
        return of(grid, extinctionPerMetre, sides, 0);
    }

    /** @param slackVoxels by which points may be below or above the cell that bounds them */
    static VoxelMaxima of(VoxelGrid grid, double extinctionPerMetre, GridAxis.Edge sides, double slackVoxels) {
        var result = new VoxelMaxima(grid, sides);
        for (int k = 0; k < result.rows; k++) {
            for (int j = 0; j < result.layers; j++) {
                for (int i = 0; i < result.columns; i++) {
                    result.maxima[result.index(i, j, k)] =
                            extinctionPerMetre * result.maximum(grid, i, j, k, slackVoxels);
                }
            }
        }
        return result;
    }

    boolean areZero() {
        return Arrays.stream(maxima).allMatch(value -> value == 0);
    }

    int columns() {
        return columns;
    }

    int rows() {
        return rows;
    }

    CellLattice lattice(Aabb box) {
        return CellLattice.dividing(box, columns, layers, rows);
    }

    private static int cells(int voxels) {
        return (voxels + VOXELS - 1) / VOXELS;
    }

    private int index(int i, int j, int k) {
        return (k * layers + j) * columns + i;
    }

    private double maximum(VoxelGrid grid, int i, int j, int k, double slack) {
        var x = new GridAxis(0, 1, grid.nx(), sides);
        var y = new GridAxis(0, 1, grid.ny(), GridAxis.Edge.CLAMPED);
        var z = new GridAxis(0, 1, grid.nz(), sides);
        float greatest = 0;
        for (int c = first(k, grid.nz(), rows, 0); c <= last(k, grid.nz(), rows, 0); c++) {
            for (int b = first(j, grid.ny(), layers, slack); b <= last(j, grid.ny(), layers, slack); b++) {
                for (int a = first(i, grid.nx(), columns, 0); a <= last(i, grid.nx(), columns, 0); a++) {
                    greatest = Math.max(greatest, grid.value(voxel(x, a), voxel(y, b), voxel(z, c)));
                }
            }
        }
        return greatest;
    }

    private static int voxel(GridAxis axis, int index) {
        return index < 0 ? axis.lower(index) : axis.upper(index - 1);
    }

    /** Returns the first voxel that influences a cell; −1 stands for the one before the grid. */
    private static int first(int cell, int voxels, int cells, double slack) {
        return (int) Math.max(-1, Math.floor((double) cell * voxels / cells - 0.5 - slack));
    }

    private static int last(int cell, int voxels, int cells, double slack) {
        return (int) Math.min(voxels, Math.floor((cell + 1.0) * voxels / cells - 0.5 + slack) + 1);
    }

    @Override
    public double perMetre(long i, long j, long k) {
        int layer = clamped(j, layers);
        return sides == GridAxis.Edge.CLAMPED
                ? maxima[index(clamped(i, columns), layer, clamped(k, rows))]
                : maxima[index((int) Math.floorMod(i, (long) columns), layer, (int) Math.floorMod(k, (long) rows))];
    }

    private static int clamped(long cell, int cells) {
        return (int) Math.max(0, Math.min(cell, cells - 1));
    }
}
