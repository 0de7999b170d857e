package nephele.engine.sim;

/**
 * Converts frame times into whole fixed ticks. It counts in integers, in billionths of a tick, which do not drift as a
 * sum of floating-point steps does.
 */
public final class FixedStep {
    public static final int MAX_TICKS_PER_FRAME = 8;
    private static final long NANOS_PER_SECOND = 1_000_000_000L;
    private static final long LONGEST_FRAME_NANOS = NANOS_PER_SECOND / 4;

    private final int ticksPerSecond;
    /** The remainder below one tick, in nanoseconds · ticks per second. */
    private long rest;

    private long droppedTicks;

    public FixedStep(int ticksPerSecond) {
        this.ticksPerSecond = ticksPerSecond;
    }

    /**
     * Returns the number of ticks due after a frame of this length: at most {@link #MAX_TICKS_PER_FRAME}. Ticks that a
     * slow machine cannot catch up with are dropped and counted. A negative time counts as 0, a frame above 0.25 s as
     * 0.25 s.
     */
    public int advance(long elapsedNanos) {
        long elapsed = Math.max(0, Math.min(elapsedNanos, LONGEST_FRAME_NANOS));
        rest += elapsed * ticksPerSecond;
        long due = rest / NANOS_PER_SECOND;
        rest %= NANOS_PER_SECOND;
        int ticks = (int) Math.min(due, MAX_TICKS_PER_FRAME);
        droppedTicks += due - ticks;
        return ticks;
    }

    /**
     * Returns the fraction of the next tick that has passed, in [0, 1): the interpolation weight between the last two
     * states.
     */
    public double share() {
        return rest / (double) NANOS_PER_SECOND;
    }

    /** Returns the number of ticks that were due and never run. */
    public long droppedTicks() {
        return droppedTicks;
    }
}
