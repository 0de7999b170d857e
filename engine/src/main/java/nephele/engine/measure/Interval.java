package nephele.engine.measure;

/**
 * A figure and where it lies with a stated confidence.
 *
 * @param low at most {@code estimate}; {@code high} at least
 */
public record Interval(double low, double estimate, double high) {
    /** Whether the data speak against {@code value}. */
    public boolean excludes(double value) {
        return value < low || value > high;
    }
}
