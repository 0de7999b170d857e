package nephele.engine.reference.tile;

/**
 * The division of a picture into squares of 16 pixels, smaller at the upper and right borders; numbered from the lower
 * left one, row by row.
 *
 * @param width pixels, as {@code height}
 */
public record PixelTiles(int width, int height) {
    public static final int SIDE = 16;

    /** @throws IllegalArgumentException for a picture without pixels */
    public PixelTiles {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height + " pixels has no tiles");
        }
    }

    private int columns() {
        return (width + SIDE - 1) / SIDE;
    }

    public int count() {
        return columns() * ((height + SIDE - 1) / SIDE);
    }

    /** Returns the leftmost column of a tile. */
    public int left(int tile) {
        return tile % columns() * SIDE;
    }

    /** Returns the lowest row of a tile. */
    public int bottom(int tile) {
        return tile / columns() * SIDE;
    }

    public int width(int tile) {
        return Math.min(SIDE, width - left(tile));
    }

    public int height(int tile) {
        return Math.min(SIDE, height - bottom(tile));
    }

    public int pixels(int tile) {
        return width(tile) * height(tile);
    }
}
