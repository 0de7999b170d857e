package nephele.engine.reference;

import nephele.engine.reference.tile.PixelTiles;

/**
 * The size and quality of a picture. The picture depends on everything but the number of threads.
 *
 * @param width pixels, {@code height} likewise; all numbers but the seed are at least 1
 * @param samples rays per pixel; a single one passes through its centre, as a rasteriser's does
 * @param seed of the pattern that the rays of a pixel form
 */
public record TraceSettings(int width, int height, int samples, long seed, int threads, LightTransport light) {
    public TraceSettings {
        if (width < 1 || height < 1 || samples < 1 || threads < 1) {
            throw new IllegalArgumentException("a picture needs pixels, samples and a thread");
        }
    }

    /** Settings for direct light. */
    public TraceSettings(int width, int height, int samples, long seed, int threads) {
        this(width, height, samples, seed, threads, LightTransport.DIRECT);
    }

    /** Returns the division of the picture into tiles. */
    public PixelTiles tiles() {
        return new PixelTiles(width, height);
    }
}
