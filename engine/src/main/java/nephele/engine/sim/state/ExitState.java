package nephele.engine.sim.state;

import java.util.List;
import nephele.engine.level.Exit;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;

/**
 * The end of a level: the first exit that the player's centre has entered, and the tick of it.
 *
 * @param exit index of the exit; {@link #NOT_REACHED} before the end
 * @param tick number of ticks since the start; 0 before the end
 */
public record ExitState(int exit, long tick) {
    /** Stands for the absence of an exit's index. */
    public static final int NOT_REACHED = -1;

    /** The state in a level without exits, which does not enter the hash. */
    public static final ExitState NONE = new ExitState(-2, 0);

    /** The state in a level with exits before the player has entered one. */
    public static final ExitState OPEN = new ExitState(NOT_REACHED, 0);

    /** Returns the state at the start of a level with these exits. */
    public static ExitState start(List<Exit> exits) {
        return exits.isEmpty() ? NONE : OPEN;
    }

    /** Returns true once the level has ended. */
    public boolean isReached() {
        return exit >= 0;
    }

    /**
     * Returns the state after a tick.
     *
     * @param centre of the player
     */
    public ExitState after(long now, Vec3 centre, List<Exit> exits) {
        if (exit != NOT_REACHED) {
            return this;
        }
        for (int i = 0; i < exits.size(); i++) {
            if (exits.get(i).contains(centre)) {
                return new ExitState(i, now);
            }
        }
        return this;
    }

    long hash(long seed) {
        return this == NONE ? seed : Hash64.combine(Hash64.combine(seed, exit), tick);
    }
}
