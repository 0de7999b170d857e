package nephele.workshop.art.paint;

/**
 * Noise that repeats with the picture. Coordinates run 0–1 over the tile in both directions and wrap. The lattice comes
 * from an integer hash, so every JVM computes the same bits.
 */
public final class TileNoise {
    private final int seed;

    public TileNoise(int seed) {
        this.seed = seed;
    }

    /**
     * The two smallest distances, in cells, to points of which each cell has one, jittered.
     *
     * @param identity random number 0–1 of the nearest point
     */
    public record Cell(double nearest, double second, double identity) {}

    /** Returns a uniform random number 0–1 for a lattice point. */
    public static double random(int i, int j, int seed) {
        int h = i * 0x1B873593 + j * 0x2545F491 + seed * 0x61C88647;
        h = (h ^ h >>> 16) * 0x7FEB352D;
        h = (h ^ h >>> 15) * 0x846CA68B;
        h ^= h >>> 16;
        return (h >>> 8) / (double) (1 << 24);
    }

    /**
     * Returns gradient noise after Perlin (2002), about −1…1, with {@code cellsX} × {@code cellsY} cells over the tile.
     */
    double smooth(double x, double y, int cellsX, int cellsY) {
        double gridX = x * cellsX;
        double gridY = y * cellsY;
        int column = (int) Math.floor(gridX);
        int row = (int) Math.floor(gridY);
        double right = gridX - column;
        double up = gridY - row;
        int column0 = Math.floorMod(column, cellsX);
        int column1 = column0 + 1 == cellsX ? 0 : column0 + 1;
        int row0 = Math.floorMod(row, cellsY);
        int row1 = row0 + 1 == cellsY ? 0 : row0 + 1;
        double a = slope(column0, row0, right, up);
        double b = slope(column1, row0, right - 1, up);
        double c = slope(column0, row1, right, up - 1);
        double d = slope(column1, row1, right - 1, up - 1);
        double s = fade(right);
        return 1.5 * mix(mix(a, b, s), mix(c, d, s), fade(up));
    }

    /** Returns the sum of octaves of {@link #smooth}, each of half the size and half the weight; about −1…1. */
    public double cloud(double x, double y, int cells, int octaves) {
        return stretched(x, y, cells, cells, octaves);
    }

    /** Returns {@link #cloud} with different cell counts in x and y. */
    public double stretched(double x, double y, int cellsX, int cellsY, int octaves) {
        double sum = 0;
        double weight = 0.5;
        for (int octave = 0; octave < octaves; octave++) {
            sum += weight * new TileNoise(seed + 101 * octave).smooth(x, y, cellsX << octave, cellsY << octave);
            weight /= 2;
        }
        return sum * 1.3;
    }

    /** Returns cellular noise after Worley (1996) with {@code cells} × {@code cells} points over the tile. */
    public Cell cell(double x, double y, int cells) {
        double gridX = x * cells;
        double gridY = y * cells;
        int column = (int) Math.floor(gridX);
        int row = (int) Math.floor(gridY);
        double nearest = 9;
        double second = 9;
        int nearestI = 0;
        int nearestJ = 0;
        for (int j = row - 1; j <= row + 1; j++) {
            int wrappedJ = Math.floorMod(j, cells);
            for (int i = column - 1; i <= column + 1; i++) {
                int wrappedI = Math.floorMod(i, cells);
                double dx = i + random(wrappedI, wrappedJ, seed) - gridX;
                double dy = j + random(wrappedI, wrappedJ, seed + 7) - gridY;
                double squared = dx * dx + dy * dy;
                if (squared < nearest) {
                    second = nearest;
                    nearest = squared;
                    nearestI = wrappedI;
                    nearestJ = wrappedJ;
                } else if (squared < second) {
                    second = squared;
                }
            }
        }
        return new Cell(Math.sqrt(nearest), Math.sqrt(second), random(nearestI, nearestJ, seed + 13));
    }

    private double slope(int column, int row, double dx, double dy) {
        double gx = random(column, row, seed + 29) * 2 - 1;
        double gy = random(column, row, seed + 31) * 2 - 1;
        return gx * dx + gy * dy;
    }

    private static double fade(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double mix(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }
}
