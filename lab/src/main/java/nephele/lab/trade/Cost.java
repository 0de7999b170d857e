package nephele.lab.trade;

/**
 * The mean cost of one run of a setting over a slice.
 *
 * @param cpuNanos CPU time by the subject's clock
 * @param bytes allocated by the running thread
 */
public record Cost(double cpuNanos, double wallNanos, double bytes) {
    public Cost meanWith(Cost other) {
        return new Cost((cpuNanos + other.cpuNanos) / 2, (wallNanos + other.wallNanos) / 2, (bytes + other.bytes) / 2);
    }
}
