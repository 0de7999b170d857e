package nephele.engine.reference.tile;

/**
 * The finished pixels of a tile, row by row from below.
 *
 * @param rgb mean radiance
 * @param variance of each value of {@code rgb}; empty if there are too few samples to know it
 */
public record TilePixels(int tile, float[] rgb, float[] variance) {}
