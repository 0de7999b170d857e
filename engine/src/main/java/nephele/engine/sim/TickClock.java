package nephele.engine.sim;

/**
 * Converts ticks to the time that shaders receive: small numbers that repeat periodically without a jump, however long
 * the game runs.
 */
public record TickClock(int ticksPerSecond) {
    /** The period of the shader time; the period of every shader animation divides it. */
    public static final int PERIOD_SECONDS = 1024;

    /** Returns the shader time in [0, {@link #PERIOD_SECONDS}); equal again one period later. */
    public float secondsInPeriod(long tick) {
        return (float) (Math.floorMod(tick, (long) PERIOD_SECONDS * ticksPerSecond) / (double) ticksPerSecond);
    }

    /**
     * Returns the phase, in [0, 2π), of a motion with {@code cyclesPerPeriod} cycles in a period; exact at any tick.
     */
    public float phaseRadians(long tick, int cyclesPerPeriod) {
        long period = (long) PERIOD_SECONDS * ticksPerSecond;
        long turned = Math.floorMod(Math.floorMod(tick, period) * cyclesPerPeriod, period);
        return (float) (2 * Math.PI * turned / period);
    }
}
