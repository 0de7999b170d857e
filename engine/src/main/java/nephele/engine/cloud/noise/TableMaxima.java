package nephele.engine.cloud.noise;

/** Greatest values of a table in blocks, for upper bounds of what is interpolated from it in a box. */
final class TableMaxima {
    /** Values along the edge of a block. */
    private static final int BLOCK = 4;

    /** A box of more blocks than these is bounded by all of them: it is large, and so is its maximum. */
    private static final int MOST_BLOCKS = 64;

    private final PeriodicTable table;
    private final int blocks;
    private final int[] maxima;
    private final int greatestOfAll;

    TableMaxima(PeriodicTable table) {
        this.table = table;
        blocks = table.size() / BLOCK;
        maxima = new int[blocks * blocks * blocks];
        int most = 0;
        for (int k = 0; k < blocks; k++) {
            for (int j = 0; j < blocks; j++) {
                for (int i = 0; i < blocks; i++) {
                    int block = maximum(BLOCK * i, BLOCK * j, BLOCK * k);
                    maxima[(k * blocks + j) * blocks + i] = block;
                    most = Math.max(most, block);
                }
            }
        }
        greatestOfAll = most;
    }

    private int maximum(int i, int j, int k) {
        int greatest = 0;
        for (int c = 0; c <= BLOCK; c++) {
            for (int b = 0; b <= BLOCK; b++) {
                for (int a = 0; a <= BLOCK; a++) {
                    greatest = Math.max(greatest, table.value(i + a, j + b, k + c));
                }
            }
        }
        return greatest;
    }

    /** Returns an upper bound of the interpolated value in a box, whose sides are given in periods. */
    double greatest(double minU, double minV, double minW, double maxU, double maxV, double maxW) {
        long firstI = block(minU);
        long firstJ = block(minV);
        long firstK = block(minW);
        int columns = count(firstI, maxU);
        int layers = count(firstJ, maxV);
        int rows = count(firstK, maxW);
        if (columns * layers * rows > MOST_BLOCKS) {
            return greatestOfAll / 65535.0;
        }
        int greatest = 0;
        for (int k = 0; k < rows; k++) {
            for (int j = 0; j < layers; j++) {
                int row = (wrapped(firstK + k) * blocks + wrapped(firstJ + j)) * blocks;
                for (int i = 0; i < columns; i++) {
                    greatest = Math.max(greatest, maxima[row + wrapped(firstI + i)]);
                }
            }
        }
        return greatest / 65535.0;
    }

    private long block(double periods) {
        return (long) Math.floor((periods * table.size() - 0.5) / BLOCK);
    }

    private int count(long first, double last) {
        return (int) Math.min(blocks, block(last) - first + 1);
    }

    /** The number of blocks is a power of two. */
    private int wrapped(long block) {
        return (int) (block & blocks - 1);
    }
}
