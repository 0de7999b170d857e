package nephele.app.trade;

/**
 * What a setting costs.
 *
 * @param name such as "CPU a frame"
 * @param unit such as "ms"
 * @param nanosPerUnit nanoseconds of one run of the experiment for one unit of cost
 */
public record CostMetric(String name, String unit, double nanosPerUnit) {
    public static final CostMetric FRAME = new CostMetric("CPU a frame", "ms", 1e6);
}
