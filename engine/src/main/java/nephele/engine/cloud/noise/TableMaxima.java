package nephele.engine.cloud.noise;

/** Greatest values of a table in blocks, for upper bounds of what is interpolated from it in a box. */
final class TableMaxima {
    /** Values along the edge of a block. */
    private static final int BLOCK = 4;

    /** A box of more blocks than these is bounded by all of them: it is large, and so is its maximum. */
    private static final int MOST_BLOCKS = 64;

    private final PeriodicTable table;
    private final int blocks;
    private final int blockLayers;
    private final int[] maxima;
    private final int greatestOfAll;

    TableMaxima(PeriodicTable table) {
        this.table = table;
        blocks = table.size() / BLOCK;
        blockLayers = Math.max(1, table.layers() / BLOCK);
        maxima = new int[blocks * blockLayers * blocks];
        int most = 0;
        for (int k = 0; k < blocks; k++) {
            for (int j = 0; j < blockLayers; j++) {
                for (int i = 0; i < blocks; i++) {
                    int block = maximum(BLOCK * i, BLOCK * j, BLOCK * k);
                    maxima[(k * blockLayers + j) * blocks + i] = block;
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
        long firstI = block(minU, blocks);
        long firstJ = block(minV, blockLayers);
        long firstK = block(minW, blocks);
        int columns = count(firstI, maxU, blocks);
        int layers = count(firstJ, maxV, blockLayers);
        int rows = count(firstK, maxW, blocks);
        if (columns * layers * rows > MOST_BLOCKS) {
            return greatestOfAll / 65535.0;
        }
        int greatest = 0;
        for (int k = 0; k < rows; k++) {
            for (int j = 0; j < layers; j++) {
                int row = (wrapped(firstK + k, blocks) * blockLayers + wrapped(firstJ + j, blockLayers)) * blocks;
                for (int i = 0; i < columns; i++) {
                    greatest = Math.max(greatest, maxima[row + wrapped(firstI + i, blocks)]);
                }
            }
        }
        return greatest / 65535.0;
    }

    /** Returns the block of a coordinate: positions from the first value's centre on are in the first block. */
    private static long block(double periods, int along) {
        return (long) Math.floor(along * periods - 0.5 / BLOCK);
    }

    private static int count(long first, double last, int along) {
        return (int) Math.min(along, block(last, along) - first + 1);
    }

    /** @param along a power of two */
    private static int wrapped(long block, int along) {
        return (int) (block & along - 1);
    }
}
