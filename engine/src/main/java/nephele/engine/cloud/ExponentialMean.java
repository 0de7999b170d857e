package nephele.engine.cloud;

/**
 * The mean of e^(−t) for t from 0 to x: (1 − e^(−x))/x. A step of optical depth x through a medium of even source has
 * this share of its thin-layer radiance. Below {@link #SERIES_BELOW} it is a series, because the difference cancels, and
 * so must a shader's be.
 */
public final class ExponentialMean {
    public static final double SERIES_BELOW = 1e-3;

    private ExponentialMean() {}

    /** Returns the mean with a relative error below 1e-12. @param x at least 0; may be infinite */
    public static double of(double x) {
        return x < SERIES_BELOW ? 1 - x / 2 * (1 - x / 3 * (1 - x / 4)) : (1 - Math.exp(-x)) / x;
    }
}
