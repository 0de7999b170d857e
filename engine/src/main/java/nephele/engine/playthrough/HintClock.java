package nephele.engine.playthrough;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Hint;
import nephele.engine.math.Vec3;

/**
 * Offers a level's hints to who has been long enough near their places, and gives one at a time, in the level's order.
 * Time is counted in ticks of the simulation, which does not know of it.
 */
public final class HintClock {
    private final List<Hint> hints;
    private final double secondsPerTick;
    private final long[] ticksNear;
    private final boolean[] isNear;
    private final List<Hint> given = new ArrayList<>();

    HintClock(List<Hint> hints, double secondsPerTick) {
        this.hints = hints;
        this.secondsPerTick = secondsPerTick;
        ticksNear = new long[hints.size()];
        isNear = new boolean[hints.size()];
    }

    /** Counts a tick. */
    void tick(Vec3 player) {
        for (int i = 0; i < ticksNear.length; i++) {
            isNear[i] = hints.get(i).near() == null || hints.get(i).near().contains(player);
            ticksNear[i] += isNear[i] ? 1 : 0;
        }
    }

    /** Returns the first hint that is due here and was not given; {@code null} for none. */
    public Hint offered() {
        for (int i = 0; i < ticksNear.length; i++) {
            boolean isDue =
                    isNear[i] && ticksNear[i] * secondsPerTick >= hints.get(i).afterSeconds();
            if (isDue && !given.contains(hints.get(i))) {
                return hints.get(i);
            }
        }
        return null;
    }

    /** Gives the hint that is offered, else the last one again; {@code null} if there is none yet. */
    public Hint give() {
        Hint next = offered();
        if (next != null) {
            given.add(next);
        }
        return given.isEmpty() ? null : given.get(given.size() - 1);
    }

    /** Returns the number of hints that were given. */
    public int given() {
        return given.size();
    }

    /** Returns the number of hints of the level. */
    public int all() {
        return hints.size();
    }
}
