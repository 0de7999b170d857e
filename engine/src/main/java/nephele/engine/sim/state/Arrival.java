package nephele.engine.sim.state;

import nephele.engine.math.Hash64;

/**
 * The memory of {@link Assist#EXIT_ROOM}: the portal that the player came out of shortly before.
 *
 * @param portal its index; {@link #NOWHERE} has −1
 * @param ticksLeft for how many ticks it still counts
 */
public record Arrival(int portal, int ticksLeft) {
    /** How long an arrival counts. */
    public static final double SECONDS = 1;

    /** The state without the assist, which does not enter the hash. */
    public static final Arrival NONE = new Arrival(-2, 0);

    /** The state with the assist while no arrival counts. */
    public static final Arrival NOWHERE = new Arrival(-1, 0);

    /** Returns the arrival in the tick in which the player comes out of a portal. */
    public static Arrival at(int portal, int ticksPerSecond) {
        return new Arrival(portal, (int) Math.ceil(SECONDS * ticksPerSecond));
    }

    /** Returns true while the arrival counts. */
    public boolean isRecent() {
        return ticksLeft > 0;
    }

    /** Returns the state in which no arrival counts. */
    public Arrival over() {
        return this == NONE ? NONE : NOWHERE;
    }

    /** Returns the arrival a tick later. */
    public Arrival later() {
        return ticksLeft > 1 ? new Arrival(portal, ticksLeft - 1) : over();
    }

    long hash(long seed) {
        return this == NONE ? seed : Hash64.combine(Hash64.combine(seed, portal), ticksLeft);
    }
}
