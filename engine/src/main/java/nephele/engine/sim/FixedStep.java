package nephele.engine.sim;

/**
 * Converts frame times into whole fixed ticks. It counts in integers, in billionths of a tick, which do not drift as a
 * sum of floating-point steps does.
 */
public final class FixedStep {
    /** The longest frame that is simulated completely: time holds down to four frames a second. */
    public static final long LONGEST_FRAME_NANOS = 250_000_000L;

    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    private final int ticksPerSecond;
    /** The remainder below one tick, in nanoseconds · ticks per second. */
    private long rest;

    private long lostNanos;

    public FixedStep(int ticksPerSecond) {
        this.ticksPerSecond = ticksPerSecond;
    }

    /**
     * Returns the number of ticks due after a frame of this length. The part of a frame beyond 0.25 s is lost and
     * counted: simulated time then passes more slowly than real time. A negative time counts as 0.
     */
    public int advance(long elapsedNanos) {
        long elapsed = Math.max(0, Math.min(elapsedNanos, LONGEST_FRAME_NANOS));
        lostNanos += Math.max(0, elapsedNanos - LONGEST_FRAME_NANOS);
        rest += elapsed * ticksPerSecond;
        long due = rest / NANOS_PER_SECOND;
        rest %= NANOS_PER_SECOND;
        return (int) due;
    }

    /**
     * Returns the fraction of the next tick that has passed, in [0, 1): the interpolation weight between the last two
     * states.
     */
    public double fraction() {
        return rest / (double) NANOS_PER_SECOND;
    }

    /** Returns the real time that was never simulated. */
    public long lostNanos() {
        return lostNanos;
    }
}
