package nephele.engine.level.billboard;

/**
 * How billboards sway in wind towards +x: their upper edge moves, the lower one stands. A function of the time alone; a
 * gust travels over a field as fast as the wind. The twin of {@code swayMetres} in {@code billboard.glsl}.
 */
public final class Sway {
    private static final double PERIOD_SECONDS = 2.6;
    private static final double FRACTION_PER_SPEED = 0.012;
    private static final double MOST_FRACTION = 0.3;
    /** The part of the lean that comes and goes. */
    public static final double SWINGING = 0.55;

    private Sway() {}

    /** Returns the greatest displacement of the upper edge, as a share of the height. */
    public static double most(double windMetresPerSecond) {
        return Math.min(MOST_FRACTION, FRACTION_PER_SPEED * windMetresPerSecond) * (1 + SWINGING);
    }

    /** Returns the steady lean of the upper edge, as a share of the height. */
    public static double lean(double windMetresPerSecond) {
        return Math.min(MOST_FRACTION, FRACTION_PER_SPEED * windMetresPerSecond);
    }

    /** Returns the turns of the swing at a time, in [0, 1); exact after years. */
    public static double turns(double seconds) {
        double turns = seconds / PERIOD_SECONDS;
        return turns - Math.floor(turns);
    }

    /** Returns the turns by which the swing is later for each metre towards +x; 0 without wind. */
    public static double turnsPerMetre(double windMetresPerSecond) {
        return windMetresPerSecond > 0 ? 1 / (PERIOD_SECONDS * windMetresPerSecond) : 0;
    }
}
