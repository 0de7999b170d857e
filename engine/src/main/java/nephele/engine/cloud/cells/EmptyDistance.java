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
        for (int sweep = 0; sweep < 2; sweep++) {
            for (int n = 0; n < distances.length; n++) {
                int at = sweep == 0 ? n : distances.length - 1 - n;
                relax(distances, cells, at, at % nx, at / nx % cells.ny(), at / layer, sweep == 0 ? -1 : 1);
            }
        }
        for (int at = 0; at < distances.length; at++) {
            distances[at] = (byte) Math.max(0, distances[at] - 1);
        }
        return distances;
    }

    private static boolean isAtSide(int index, int count) {
        return index == 0 || index == count - 1;
    }

    /** Regards the thirteen neighbours that a sweep has passed already. */
    private static void relax(byte[] distances, CellBox cells, int at, int i, int j, int k, int side) {
        int least = distances[at];
        for (int n = 0; n < 13 && least > 0; n++) {
            int dx = n < 9 ? n % 3 - 1 : n < 12 ? n - 10 : side;
            int dy = n < 9 ? n / 3 - 1 : n < 12 ? side : 0;
            int dz = n < 9 ? side : 0;
            boolean inside = within(i + dx, cells.nx()) && within(j + dy, cells.ny()) && within(k + dz, cells.nz());
            if (inside) {
                least = Math.min(least, distances[cells.index(i + dx, j + dy, k + dz)] + 1);
            }
        }
        distances[at] = (byte) least;
    }

    private static boolean within(int index, int count) {
        return index >= 0 && index < count;
    }
}
