package nephele.engine.sim;

import java.util.List;

/** What a replay has to know besides the level. Assists are in the order of the enum. */
public record SimSettings(int ticksPerSecond, List<Assist> assists) {
    public static final int LEAST_TICKS_PER_SECOND = 10;
    public static final int MOST_TICKS_PER_SECOND = 1000;
    public static final SimSettings DEFAULT = new SimSettings(120, List.of());

    /** @throws IllegalArgumentException when the rate is out of range */
    public SimSettings {
        if (ticksPerSecond < LEAST_TICKS_PER_SECOND || ticksPerSecond > MOST_TICKS_PER_SECOND) {
            throw new IllegalArgumentException("ticks per second must be " + LEAST_TICKS_PER_SECOND + " to "
                    + MOST_TICKS_PER_SECOND + ", not " + ticksPerSecond);
        }
        assists = assists.stream().distinct().sorted().toList();
    }

    public SimSettings withTicksPerSecond(int changed) {
        return new SimSettings(changed, assists);
    }
}
