package nephele.engine.cloud.noise;

/**
 * Values of 0 to 1 on a square base, in one layer or as many as make a cube, that repeat without end, in 16 bits. Between
 * values it is interpolated as a texture of OpenGL with the format R16, GL_LINEAR and GL_REPEAT: value i of an edge of n
 * is at (i + ½)/n of the period.
 */
public final class PeriodicTable {
    private static final double MOST = 65535;

    /** Values along the edge of a block of which the greatest value is kept. */
    private static final int BLOCK = 4;

    /** A box of more blocks than these is bounded by all of them: it is large, and so is its maximum. */
    private static final int MOST_BLOCKS = 64;

    private final int size;
    private final int layers;
    private final int mask;
    private final int layerMask;
    private final short[] values;

    /** Blocks along an edge of the base, each of {@value #BLOCK} values along its edges. */
    private final int blocks;

    private final int blockLayers;
    /** The greatest value that interpolation in a block meets. */
    private final int[] maxima;

    private final int greatestOfAll;

    /**
     * @param size values along an edge of the base; a power of two
     * @param values unsigned, x fastest, then y, which is up, then z; kept, not copied
     */
    private PeriodicTable(int size, short[] values) {
        layers = values.length / (size * size);
        if (Integer.bitCount(size) != 1 || Integer.bitCount(layers) != 1 || layers * size * size != values.length) {
            throw new IllegalArgumentException(values.length + " values have no square base of " + size);
        }
        this.size = size;
        this.values = values;
        mask = size - 1;
        layerMask = layers - 1;
        blocks = size / BLOCK;
        blockLayers = Math.max(1, layers / BLOCK);
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
                    greatest = Math.max(greatest, value(i + a, j + b, k + c));
                }
            }
        }
        return greatest;
    }

    /** Returns the table whose values are the ranks of these: each fraction of 0 to 1 holds as large a fraction of them. */
    static PeriodicTable ranked(int size, float[] unordered) {
        int[] counts = new int[1 << 16];
        float least = Float.POSITIVE_INFINITY;
        float most = Float.NEGATIVE_INFINITY;
        for (float value : unordered) {
            least = Math.min(least, value);
            most = Math.max(most, value);
        }
        float scale = (counts.length - 1) / Math.max(most - least, Float.MIN_NORMAL);
        for (float value : unordered) {
            counts[(int) ((value - least) * scale)]++;
        }
        short[] ranks = new short[counts.length];
        long below = 0;
        for (int bin = 0; bin < counts.length; bin++) {
            ranks[bin] = (short) Math.round(MOST * (below + counts[bin] / 2.0) / unordered.length);
            below += counts[bin];
        }
        short[] values = new short[unordered.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = ranks[(int) ((unordered[i] - least) * scale)];
        }
        return new PeriodicTable(size, values);
    }

    /** Returns the number of values along x and along z. */
    public int size() {
        return size;
    }

    /** Returns the number of values along y: 1 or the size. */
    public int layers() {
        return layers;
    }

    /** Returns a copy of the values as a texture takes them: unsigned, x fastest, then y, then z. */
    public short[] unorm16() {
        return values.clone();
    }

    /** Returns a value of the table, 0 to 65535; indices are taken modulo the size. */
    int value(int i, int j, int k) {
        return values[((k & mask) * layers + (j & layerMask)) * size + (i & mask)] & 0xffff;
    }

    /**
     * Returns the interpolated value, 0 to 1.
     *
     * @param u coordinate in periods; {@code v} and {@code w} likewise
     */
    public double at(double u, double v, double w) {
        double x = size * (u - Math.floor(u)) - 0.5;
        double y = layers * (v - Math.floor(v)) - 0.5;
        double z = size * (w - Math.floor(w)) - 0.5;
        int i = floor(x);
        int j = floor(y);
        int k = floor(z);
        double ofX = x - i;
        double ofY = y - j;
        int left = i & mask;
        int right = i + 1 & mask;
        int lower = (j & layerMask) * size;
        int upper = (j + 1 & layerMask) * size;
        double near = plane((k & mask) * layers * size, left, right, lower, upper, ofX, ofY);
        double far = plane((k + 1 & mask) * layers * size, left, right, lower, upper, ofX, ofY);
        return (near + (far - near) * (z - k)) / MOST;
    }

    /** Rounds a number of at least −½ down. */
    private static int floor(double coordinate) {
        return coordinate < 0 ? -1 : (int) coordinate;
    }

    private double plane(int first, int left, int right, int lower, int upper, double ofX, double ofY) {
        double below = row(first + lower, left, right, ofX);
        return below + (row(first + upper, left, right, ofX) - below) * ofY;
    }

    private double row(int first, int left, int right, double ofX) {
        int from = values[first + left] & 0xffff;
        return from + ((values[first + right] & 0xffff) - from) * ofX;
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
            return greatestOfAll / MOST;
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
        return greatest / MOST;
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
