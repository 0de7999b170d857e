package nephele.engine.cloud.noise;

/**
 * Values of 0 to 1 on a square base, in one layer or as many as make a cube, that repeat without end, in 16 bits. Between
 * values it is interpolated as a texture of OpenGL with the format R16, GL_LINEAR and GL_REPEAT: value i of an edge of n
 * is at (i + ½)/n of the period.
 */
public final class PeriodicTable {
    private static final double MOST = 65535;

    private final int size;
    private final int layers;
    private final int mask;
    private final int layerMask;
    private final short[] values;
    private volatile TableMaxima maxima;

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
    }

    /** Returns the table whose values are the ranks of these: each share of 0 to 1 holds as large a share of them. */
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

    /** Returns the greatest values of blocks, found once. */
    TableMaxima maxima() {
        TableMaxima found = maxima;
        if (found == null) {
            found = new TableMaxima(this);
            maxima = found;
        }
        return found;
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
}
