package nephele.engine.sim;

import java.util.List;

/**
 * What a replay has to know besides the level. Assists are in the order of the enum.
 *
 * @param uprightDegreesPerSecond how fast the view turns upright after a portal has left it leaning; shots go where the
 *     view looks, so it is no matter of the picture alone. The body turns as room allows, whatever this says
 */
public record SimSettings(int ticksPerSecond, List<Assist> assists, int uprightDegreesPerSecond) {
    public static final int LEAST_TICKS_PER_SECOND = 10;
    public static final int MOST_TICKS_PER_SECOND = 1000;
    public static final int DEFAULT_UPRIGHT_DEGREES_PER_SECOND = 360;
    public static final int LEAST_UPRIGHT_DEGREES_PER_SECOND = 10;
    /** Half a turn within one tick, at every rate. */
    public static final int INSTANT_UPRIGHT_DEGREES_PER_SECOND = 180 * MOST_TICKS_PER_SECOND;

    public static final SimSettings DEFAULT = new SimSettings(120, List.of());

    /** @throws IllegalArgumentException when a rate is out of range */
    public SimSettings {
        if (ticksPerSecond < LEAST_TICKS_PER_SECOND || ticksPerSecond > MOST_TICKS_PER_SECOND) {
            throw new IllegalArgumentException("ticks per second must be " + LEAST_TICKS_PER_SECOND + " to "
                    + MOST_TICKS_PER_SECOND + ", not " + ticksPerSecond);
        }
        if (uprightDegreesPerSecond < LEAST_UPRIGHT_DEGREES_PER_SECOND
                || uprightDegreesPerSecond > INSTANT_UPRIGHT_DEGREES_PER_SECOND) {
            throw new IllegalArgumentException("degrees per second upright must be " + LEAST_UPRIGHT_DEGREES_PER_SECOND
                    + " to " + INSTANT_UPRIGHT_DEGREES_PER_SECOND + ", not " + uprightDegreesPerSecond);
        }
        assists = assists.stream().distinct().sorted().toList();
    }

    /** The view turns upright as fast as the body does. */
    public SimSettings(int ticksPerSecond, List<Assist> assists) {
        this(ticksPerSecond, assists, DEFAULT_UPRIGHT_DEGREES_PER_SECOND);
    }

    public SimSettings withTicksPerSecond(int changed) {
        return new SimSettings(changed, assists, uprightDegreesPerSecond);
    }

    public SimSettings withUprightDegreesPerSecond(int changed) {
        return new SimSettings(ticksPerSecond, assists, changed);
    }
}
