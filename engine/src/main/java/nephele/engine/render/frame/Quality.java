package nephele.engine.render.frame;

/**
 * What may be traded for speed.
 *
 * @param anisotropy texture samples along the steepest direction, at most
 * @param shadowTexels longer side of the sun's shadow map, at most
 * @param samples coverage samples a pixel, at most; 1 draws without multisampling
 */
public record Quality(int anisotropy, int shadowTexels, int samples) {
    public static final Quality LOW = new Quality(1, 1024, 1);
    public static final Quality MEDIUM = new Quality(1, 2048, 1);
    public static final Quality HIGH = new Quality(1, 4096, 1);
    public static final Quality ULTRA = new Quality(8, 4096, 4);

    public Quality withSamples(int newSamples) {
        return new Quality(anisotropy, shadowTexels, newSamples);
    }
}
