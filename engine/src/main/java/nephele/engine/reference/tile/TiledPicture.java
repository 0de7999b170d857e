package nephele.engine.reference.tile;

import java.util.BitSet;

/** A picture that tiles are put into, from any thread. */
public final class TiledPicture {
    /** Pixels on each side of one over which its variance is averaged. */
    private static final int SMOOTHED = 2;

    private final PixelTiles tiles;
    private final float[] rgb;
    private final BitSet put = new BitSet();
    private float[] variance;

    public TiledPicture(PixelTiles tiles) {
        this.tiles = tiles;
        rgb = new float[3 * tiles.width() * tiles.height()];
        variance = new float[rgb.length];
    }

    public synchronized void put(TilePixels pixels) {
        put.set(pixels.tile());
        copy(pixels.rgb(), rgb, pixels.tile());
        if (pixels.variance().length == 0) {
            variance = null;
        } else if (variance != null) {
            copy(pixels.variance(), variance, pixels.tile());
        }
    }

    private void copy(float[] from, float[] to, int tile) {
        int length = 3 * tiles.width(tile);
        for (int row = 0; row < tiles.height(tile); row++) {
            int at = 3 * ((tiles.bottom(tile) + row) * tiles.width() + tiles.left(tile));
            System.arraycopy(from, row * length, to, at, length);
        }
    }

    public synchronized boolean has(int tile) {
        return put.get(tile);
    }

    public PixelTiles tiles() {
        return tiles;
    }

    /** Returns radiance, RGB, the bottom row first. */
    public float[] rgb() {
        return rgb;
    }

    /** Returns false if a tile has no variance. */
    public boolean hasError() {
        return variance != null;
    }

    /**
     * Returns the standard error of each value: the root of the variance, averaged over the 5 by 5 pixels around, as far as
     * they are in the picture.
     */
    public float[] standardError() {
        float[] error = new float[rgb.length];
        for (int y = 0; y < tiles.height(); y++) {
            for (int x = 0; x < tiles.width(); x++) {
                for (int channel = 0; channel < 3; channel++) {
                    error[3 * (y * tiles.width() + x) + channel] = (float) Math.sqrt(smoothed(x, y, channel));
                }
            }
        }
        return error;
    }

    private double smoothed(int x, int y, int channel) {
        double sum = 0;
        int count = 0;
        for (int j = Math.max(0, y - SMOOTHED); j <= Math.min(tiles.height() - 1, y + SMOOTHED); j++) {
            for (int i = Math.max(0, x - SMOOTHED); i <= Math.min(tiles.width() - 1, x + SMOOTHED); i++) {
                sum += variance[3 * (j * tiles.width() + i) + channel];
                count++;
            }
        }
        return sum / count;
    }
}
