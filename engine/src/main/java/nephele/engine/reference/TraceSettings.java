package nephele.engine.reference;

/**
 * How much of a picture is computed, and by how many. The picture depends on all of it but the threads.
 *
 * @param samples rays a pixel; a single one goes through its middle, as a rasteriser's does
 * @param seed of the pattern that the rays of a pixel form
 */
public record TraceSettings(int width, int height, int samples, long seed, int threads) {
    public TraceSettings {
        if (width < 1 || height < 1 || samples < 1 || threads < 1) {
            throw new IllegalArgumentException("a picture needs pixels, samples and a thread");
        }
    }
}
