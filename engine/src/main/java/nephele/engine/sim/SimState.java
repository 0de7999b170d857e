package nephele.engine.sim;

/**
 * Everything that the next tick depends on, besides the level and the input.
 *
 * @param tick how many ticks have passed since the start
 * @param random the state of the one generator
 * @param faults how often a tick was undone because it gave numbers that are not finite
 */
public record SimState(long tick, long random, int faults, PlayerState player) {
    /** 64 bits over every bit of the state, equal on every machine. */
    public long hash() {
        long hash = StateHash.join(StateHash.join(0, tick), random);
        return player.hash(StateHash.join(hash, faults));
    }
}
