package nephele.engine.sim;

import nephele.engine.portal.Portals;

/**
 * What can change in a level besides the player. Parts that the level does not ask for are their empty constants: they
 * cost nothing and leave the hash as it is without them.
 *
 * @param portals the level's fixed ones, in its order, then those that were shot, in the order of their first shots: an
 *     index once given keeps its meaning
 * @param shots which of them are the gun's
 * @param holding what the player holds
 * @param trace what the last tick did
 */
public record Changeable(Portals portals, Shots shots, Holding holding, TickTrace trace) {
    public static final Changeable NOTHING = new Changeable(Portals.NONE, Shots.NONE, Holding.NOTHING, TickTrace.NONE);

    long hash(long seed) {
        long hash = portals.size() == 0 ? seed : PortalHash.join(seed, portals);
        return trace.hash(holding.hash(shots.hash(hash)));
    }
}
