package nephele.engine.asset;

/**
 * Painted layers of a terrain as a file stores them: each texel names one layer and the weight with which it replaces what
 * would be there.
 *
 * @param texels rows from the top, texels from the left; of each the layer's index, then its weight, 0 to 255
 */
public record LayerMap(int columns, int rows, byte[] texels) {
    /** The weight that replaces all. */
    public static final int FULL_WEIGHT = 255;

    /** Bytes of a texel. */
    public static final int TEXEL_BYTES = 2;

    public LayerMap {
        if (TEXEL_BYTES * columns * rows != texels.length) {
            throw new IllegalArgumentException("texels do not fit " + columns + "x" + rows);
        }
    }

    /** Returns a map that changes nothing. */
    public static LayerMap blank(int columns, int rows) {
        return new LayerMap(columns, rows, new byte[TEXEL_BYTES * columns * rows]);
    }

    /** Returns the index of a texel's layer; it means nothing where the weight is 0. */
    public int layer(int column, int row) {
        return texels[TEXEL_BYTES * (row * columns + column)] & 0xff;
    }

    /** Returns the weight of a texel's layer, 0 to {@link #FULL_WEIGHT}. */
    public int weight(int column, int row) {
        return texels[TEXEL_BYTES * (row * columns + column) + 1] & 0xff;
    }
}
