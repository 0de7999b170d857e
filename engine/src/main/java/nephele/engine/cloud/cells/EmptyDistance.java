package nephele.engine.cloud.cells;

import java.util.Arrays;

/** Distances of cells to the nearest one with a density, along the greatest coordinate (Chebyshev's distance). */
final class EmptyDistance {
    private EmptyDistance() {}

    /**
     * Returns the distance of each cell: 0 where linear filtering at any point of the cell may see a density, then in
     * cells, at most {@code farthest}. What lies beside the box counts as density.
     */
    static byte[] of(CellBox cells, float[] densities, int farthest) {
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
