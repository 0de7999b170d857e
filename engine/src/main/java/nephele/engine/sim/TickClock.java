package nephele.engine.sim;

/** Ticks as the time that shaders see: small numbers that repeat without a seam, however long the game runs. */
public record TickClock(int ticksPerSecond) {
    /** Whatever moves in a shader has a period that divides this. */
    public static final int PERIOD_SECONDS = 1024;

    /** In [0, {@link #PERIOD_SECONDS}); equal again one period later. */
    public float secondsInPeriod(long tick) {
        return (float) (Math.floorMod(tick, (long) PERIOD_SECONDS * ticksPerSecond) / (double) ticksPerSecond);
    }

    /** The phase, in [0, 2π), of what turns {@code cyclesPerPeriod} times in a period; exact at any tick. */
    public float phaseRadians(long tick, int cyclesPerPeriod) {
        long period = (long) PERIOD_SECONDS * ticksPerSecond;
        long turned = Math.floorMod(Math.floorMod(tick, period) * cyclesPerPeriod, period);
        return (float) (2 * Math.PI * turned / period);
    }
}
