package nephele.engine.sim;

import nephele.engine.math.BitHash;

/**
 * Everything that the next tick depends on, besides the level and the input.
 *
 * @param tick the number of ticks since the start
 * @param random the state of the only random generator
 * @param faults how often a tick was undone because it gave numbers that are not finite, a body was frozen for that, or
 *     time was dropped after too many portals
 * @param around the world state: bodies, portals, what is held
 */
public record SimState(long tick, long random, int faults, PlayerState player, Changeable around) {
    /** Creates a state in a level where nothing changes except the player. */
    public SimState(long tick, long random, int faults, PlayerState player) {
        this(tick, random, faults, player, Changeable.NOTHING);
    }

    /** Returns this state with another player. */
    public SimState withPlayer(PlayerState changed) {
        return new SimState(tick, random, faults, changed, around);
    }

    SimState withFaults(int changed) {
        return changed == faults ? this : new SimState(tick, random, changed, player, around);
    }

    public SimState with(Changeable changed) {
        return changed == around ? this : new SimState(tick, random, faults, player, changed);
    }

    /** Returns a 64-bit hash over every bit of the state, equal on every machine. */
    public long hash() {
        long hash = BitHash.join(BitHash.join(0, tick), random);
        return around.hash(player.hash(BitHash.join(hash, faults)));
    }
}
