package nephele.engine.cloud.field;

/** The error function erf(x) = 2/√π ∫₀ˣ exp(−t²) dt; Abramowitz and Stegun 1964, chapter 7. */
final class ErrorFunction {
    /** Above it the continued fraction converges faster than the series. */
    private static final double SERIES_END = 2.5;

    /** Above it erf is 1 in double precision. */
    private static final double ONE_FROM = 6;

    private static final double TWO_BY_ROOT_PI = 2 / Math.sqrt(Math.PI);
    private static final int FRACTION_TERMS = 60;

    private ErrorFunction() {}

    /** Returns erf(x) with an absolute error below 1e-15. */
    static double erf(double x) {
        double size = Math.abs(x);
        if (size >= ONE_FROM) {
            return Math.signum(x);
        }
        return size <= SERIES_END ? series(x) : Math.signum(x) * (1 - tail(size));
    }

    /** Sums formula 7.1.6, whose terms all have the sign of x. */
    private static double series(double x) {
        double term = x;
        double sum = x;
        for (int n = 1; Math.abs(term) > 1e-17 * Math.abs(sum); n++) {
            term *= 2 * x * x / (2 * n + 1);
            sum += term;
        }
        return TWO_BY_ROOT_PI * Math.exp(-x * x) * sum;
    }

    /** Returns 1 − erf(x) by the continued fraction 7.1.14. */
    private static double tail(double x) {
        double fraction = x;
        for (int n = FRACTION_TERMS; n > 0; n--) {
            fraction = x + n / 2.0 / fraction;
        }
        return Math.exp(-x * x) / (Math.sqrt(Math.PI) * fraction);
    }
}
