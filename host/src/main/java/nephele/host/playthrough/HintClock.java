package nephele.host.playthrough;

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

    /** @param hints of the level, in its order */
    public HintClock(List<Hint> hints, double secondsPerTick) {
        this.hints = hints;
        this.secondsPerTick = secondsPerTick;
        ticksNear = new long[hints.size()];
        isNear = new boolean[hints.size()];
    }

    /** Counts a tick. */
    public void tick(Vec3 player) {
        for (int i = 0; i < ticksNear.length; i++) {
            isNear[i] = hints.get(i).near() == null || hints.get(i).near().contains(player);
            ticksNear[i] += isNear[i] ? 1 : 0;
        }
    }

    /** Returns the first hint that is due here and was not given; {@code null} for none. */
    public Hint offered() {
        return offered(0);
    }

    private Hint offered(double earlySeconds) {
        for (int i = 0; i < ticksNear.length; i++) {
            if (isNext(i) && secondsTo(i) <= earlySeconds) {
                return hints.get(i);
            }
        }
        return null;
    }

    /** Returns true if a hint was not given and can be given here. */
    private boolean isNext(int i) {
        return isNear[i] && !given.contains(hints.get(i));
    }

    private double secondsTo(int i) {
        return hints.get(i).afterSeconds() - ticksNear[i] * secondsPerTick;
    }

    /** Returns the time of play here until the next hint is due: 0 if one is, infinite if none comes here. */
    public double secondsToNext() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ticksNear.length; i++) {
            least = isNext(i) ? Math.min(least, Math.max(0, secondsTo(i))) : least;
        }
        return least;
    }

    /**
     * Gives the first hint that is offered or will be soon, else the last one again; {@code null} if there is none yet.
     *
     * @param earlySeconds the time before it is due in which it is given too
     */
    public Hint give(double earlySeconds) {
        Hint next = offered(earlySeconds);
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
