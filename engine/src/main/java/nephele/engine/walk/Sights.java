package nephele.engine.walk;

/**
 * What the crosshair says.
 *
 * @param right where a shot would hit, in points from the middle of the picture; {@code down} alike
 * @param first what the first shot would do, {@code null} without a gun; {@code second} alike
 */
public record Sights(double right, double down, Half first, Half second) {
    public static final Sights MIDDLE = new Sights(0, 0, null, null);

    /** Whether the shot's portal is already somewhere. */
    public enum Portal {
        NONE,
        MADE
    }

    /** Whether a shot would open it where it points. */
    public enum Shot {
        OPENS,
        REFUSED
    }

    /** One of the two. */
    public record Half(Portal portal, Shot shot) {}
}
