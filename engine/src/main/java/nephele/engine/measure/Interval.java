package nephele.engine.measure;

/**
 * An estimate with its confidence interval.
 *
 * @param low at most {@code estimate}
 * @param high at least {@code estimate}
 */
public record Interval(double low, double estimate, double high) {
    /** Returns true if {@code value} is outside of the interval. */
    public boolean excludes(double value) {
        return value < low || value > high;
    }
}
