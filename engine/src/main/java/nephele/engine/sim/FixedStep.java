package nephele.engine.sim;

/**
 * Cuts the time that frames take into whole ticks. Counts in integers: billionths of a tick never drift as a sum of
 * floating-point steps does.
 */
public final class FixedStep {
    public static final int MAX_TICKS_PER_FRAME = 8;
    private static final long NANOS_PER_SECOND = 1_000_000_000L;
    private static final long LONGEST_FRAME_NANOS = NANOS_PER_SECOND / 4;

    private final int ticksPerSecond;
    /** Below one tick, in nanoseconds · ticks per second. */
    private long rest;

    private long droppedTicks;

    public FixedStep(int ticksPerSecond) {
        this.ticksPerSecond = ticksPerSecond;
    }

    /**
     * How many ticks are due after a frame of this length: at most {@link #MAX_TICKS_PER_FRAME}. What a slow machine
     * cannot catch up with is dropped and counted; a clock that runs backwards counts as 0.
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

    /** The share of the next tick that has passed, in [0, 1): between the last two states. */
    public double share() {
        return rest / (double) NANOS_PER_SECOND;
    }

    /** Ticks that were due and never run. */
    public long droppedTicks() {
        return droppedTicks;
    }
}
