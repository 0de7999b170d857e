package nephele.lab.trade;

/**
 * What a setting costs.
 *
 * @param name such as "CPU a frame"
 * @param unit such as "ms"
 * @param unitNanos nanoseconds of one unit
 * @param perRun how many frames, ticks, placements one run of the experiment does
 */
public record CostMetric(String name, String unit, double unitNanos, double perRun, Clock clock) {
    /** A rasteriser in software has threads of its own, and they are what a frame costs. */
    public static final CostMetric FRAME = new CostMetric("CPU a frame", "ms", 1e6, 1, Clock.PROCESS);

    /** Whose CPU time counts. */
    public enum Clock {
        PROCESS,
        /** The running thread's: what the JVM compiles meanwhile does not count. */
        THREAD
    }

    /** What a run's nanoseconds are in units, each. */
    double scale() {
        return 1 / (unitNanos * perRun);
    }
}
