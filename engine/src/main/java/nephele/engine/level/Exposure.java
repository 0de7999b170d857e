package nephele.engine.level;

/**
 * Exposure of the picture: stops that the author chose, or {@code "auto"}: stops metered from the picture itself.
 *
 * @param fixedStops exposure = 2^stops; {@code null} for auto
 */
public record Exposure(Double fixedStops) {
    /** The word in a file for {@link #AUTO}. */
    public static final String AUTO_WORD = "auto";

    public static final Exposure AUTO = new Exposure(null);

    /** Leaves radiance as it is. */
    public static final Exposure NEUTRAL = ofStops(0);

    public static Exposure ofStops(double stops) {
        return new Exposure(stops);
    }

    public boolean isAuto() {
        return fixedStops == null;
    }

    /**
     * Returns the stops.
     *
     * @param metered the value for auto
     */
    public double stopsOr(double metered) {
        return isAuto() ? metered : fixedStops;
    }

    /** Returns the number, or the word, as in a file. */
    @Override
    public String toString() {
        return isAuto() ? AUTO_WORD : fixedStops.toString();
    }
}
