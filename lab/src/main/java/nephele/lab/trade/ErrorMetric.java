package nephele.lab.trade;

/**
 * A measure of the difference between a setting and the exact twin. Smaller is better, 0 is exact.
 *
 * @param name of the error
 * @param unit may be empty
 * @param step resolution of the measurement: errors that differ by no more count as equal
 * @param enough a setting with an error no more than this above the best one is recommended if it is cheaper
 */
public record ErrorMetric(String name, String unit, double step, double enough) {
    /**
     * The error of pictures of radiance. An error of a tenth of the range on a fiftieth of the picture counts as
     * visible.
     */
    public static final ErrorMetric PICTURE = new ErrorMetric("mean HDR-FLIP", "", 5e-4, 2e-3);

    /** Mean FLIP of displayed pictures; the step and the threshold are those of {@link #PICTURE}. */
    public static final ErrorMetric DISPLAYED = new ErrorMetric("mean FLIP as displayed", "", 5e-4, 2e-3);
}
