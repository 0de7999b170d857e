package nephele.engine.sim.state;

import nephele.engine.math.Hash64;

/**
 * Everything that the next tick depends on, besides the level and the input.
 *
 * @param tick the number of ticks since the start
 * @param random the state of the only random generator
 * @param faults how often a tick was undone because it gave numbers that are not finite, a body was frozen for that, or
 *     time was dropped after too many portals
 * @param world the world state: bodies, portals, what is held
 */
public record SimState(long tick, long random, int faults, PlayerState player, WorldState world) {
    /** Creates a state in a level where nothing changes except the player. */
    public SimState(long tick, long random, int faults, PlayerState player) {
        this(tick, random, faults, player, WorldState.NOTHING);
    }

    /** Returns this state with another player. */
    public SimState withPlayer(PlayerState changed) {
        return new SimState(tick, random, faults, changed, world);
    }

    public SimState withFaults(int changed) {
        return changed == faults ? this : new SimState(tick, random, changed, player, world);
    }

    public SimState with(WorldState changed) {
        return changed == world ? this : new SimState(tick, random, faults, player, changed);
    }

    /** Returns a 64-bit hash over every bit of the state, equal on every machine. */
    public long hash() {
        long hash = Hash64.combine(Hash64.combine(0, tick), random);
        return world.hash(player.hash(Hash64.combine(hash, faults)));
    }
}
