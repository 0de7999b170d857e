package nephele.lab.trade;

/**
 * How far from the exact twin a setting is. Smaller is better, 0 is exact.
 *
 * @param name of the figure
 * @param unit may be empty
 * @param step errors that differ by no more count as equal: what the measurement cannot tell
 * @param enough a setting that errs by no more than this above the best one is recommended if it is cheaper
 */
public record ErrorMetric(String name, String unit, double step, double enough) {
    /** Of pictures of radiance. What is wrong by a tenth of the range on a fiftieth of the picture is called visible. */
    public static final ErrorMetric PICTURE = new ErrorMetric("mean HDR-FLIP", "", 5e-4, 2e-3);
}
