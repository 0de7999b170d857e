package nephele.engine.render.frame;

/**
 * What may be traded for speed.
 *
 * @param anisotropy texture samples along the steepest direction, at most
 * @param shadowTexels longer side of the sun's shadow map, at most
 */
public record Quality(int anisotropy, int shadowTexels) {
    public static final Quality LOW = new Quality(1, 1024);
    public static final Quality MEDIUM = new Quality(1, 2048);
    public static final Quality HIGH = new Quality(1, 4096);
    public static final Quality ULTRA = new Quality(8, 4096);
}
