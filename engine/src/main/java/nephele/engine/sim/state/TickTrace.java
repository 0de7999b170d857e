package nephele.engine.sim.state;

import java.util.List;
import nephele.engine.math.Hash64;
import nephele.engine.portal.CrossingWord;

/**
 * The data that a tick passes to the next one and to the interpolated picture between the two.
 *
 * @param pressed the bits of the hands' actions that were held: they act again only after a release
 * @param playerCrossed the portals that the player went through in this tick
 * @param events for the player
 */
public record TickTrace(int pressed, CrossingWord playerCrossed, List<TickEvent> events) {
    public static final TickTrace NONE = new TickTrace(0, CrossingWord.EMPTY, List.of());

    public TickTrace {
        events = List.copyOf(events);
    }

    public static TickTrace of(int pressed, CrossingWord playerCrossed, List<TickEvent> events) {
        boolean isNone = pressed == 0 && playerCrossed.length() == 0 && events.isEmpty();
        return isNone ? NONE : new TickTrace(pressed, playerCrossed, events);
    }

    long hash(long seed) {
        if (equals(NONE)) {
            return seed;
        }
        long hash = playerCrossed.hash(Hash64.combine(seed, pressed));
        for (TickEvent event : events) {
            hash = event.hash(hash);
        }
        return hash;
    }
}
