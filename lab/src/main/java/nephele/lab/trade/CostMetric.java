package nephele.lab.trade;

/**
 * The cost that a subject reports, and its unit.
 *
 * @param name such as "CPU a frame"
 * @param unit such as "ms"
 * @param unitNanos nanoseconds of one unit
 * @param perRun number of frames, ticks or placements in one run of the experiment
 */
public record CostMetric(String name, String unit, double unitNanos, double perRun, Clock clock) {
    /** CPU time a frame, of the whole process: a software rasteriser draws in threads of its own. */
    public static final CostMetric FRAME = new CostMetric("CPU a frame", "ms", 1e6, 1, Clock.PROCESS);

    /** The threads of which CPU time is counted. */
    public enum Clock {
        PROCESS,
        /** Only the running thread, so that the JVM's compiler threads do not count. */
        THREAD
    }

    /** Returns the factor from a run's nanoseconds to the cost of one item in {@code unit}. */
    double scale() {
        return 1 / (unitNanos * perRun);
    }
}
