package nephele.engine.sim.state;

import nephele.engine.math.Hash64;

/**
 * The memory of {@link Assist#SAFE_RETURN}: where the player last stood, and when it last fell out of the level and came
 * back. The picture fades by {@link #darkness}.
 *
 * @param safe the player at rest where it had static ground for {@link #STOOD_SECONDS} from then on, last of all
 * @param candidate the player at rest in the next such place, if it keeps ground for so long; {@code null} for none
 * @param candidateTick the tick of the candidate; 0 for none
 * @param fellTick the tick in which the player last fell below everything solid; {@link #NEVER} for none
 * @param returnedTick the tick in which it last came back; {@link #NEVER} for none
 */
public record FallState(PlayerState safe, PlayerState candidate, long candidateTick, long fellTick, long returnedTick) {
    /** How long the player has to have ground under it. */
    public static final double STOOD_SECONDS = 0.5;

    /** How long the picture takes to turn black during a fall, and how long to come back. */
    public static final double FADE_SECONDS = 0.25;

    /** Stands for the absence of a tick. */
    public static final long NEVER = -1;

    /** The state without the assist, which does not enter the hash. */
    public static final FallState NONE = new FallState(null, null, 0, NEVER, NEVER);

    /** Returns the state at the start of a level. */
    public static FallState start(PlayerState player) {
        return new FallState(player, null, 0, NEVER, NEVER);
    }

    /** Returns true while the player falls below everything solid, before it comes back. */
    public boolean isFalling() {
        return fellTick > returnedTick;
    }

    /** Returns the state after the player has fallen below everything solid. */
    public FallState fell(long tick) {
        return new FallState(safe, null, 0, tick, returnedTick);
    }

    /** Returns the state after the player has come back. */
    public FallState returned(long tick) {
        return new FallState(safe, null, 0, fellTick, tick);
    }

    /** Returns this state with another candidate, {@code null} for none. */
    public FallState withCandidate(PlayerState player, long tick) {
        return new FallState(safe, player, player == null ? 0 : tick, fellTick, returnedTick);
    }

    /** Returns this state with the candidate as the place to return to. */
    public FallState confirmed() {
        return new FallState(candidate, null, 0, fellTick, returnedTick);
    }

    /**
     * Returns how dark the picture is for a fall, 0 (as always) to 1 (black).
     *
     * @param ticks since the start, with the fraction of a tick that the picture shows
     */
    public double darkness(double ticks, int ticksPerSecond) {
        double fade = FADE_SECONDS * ticksPerSecond;
        if (isFalling()) {
            return Math.max(0, Math.min(1, (ticks - fellTick) / fade));
        }
        return returnedTick == NEVER ? 0 : Math.max(0, Math.min(1, 1 - (ticks - returnedTick) / fade));
    }

    long hash(long seed) {
        if (this == NONE) {
            return seed;
        }
        long hash = safe.hash(seed);
        hash = candidate == null ? Hash64.combine(hash, 0) : candidate.hash(hash);
        return Hash64.combine(Hash64.combine(Hash64.combine(hash, candidateTick), fellTick), returnedTick);
    }
}
