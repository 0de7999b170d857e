package nephele.engine.sim;

import nephele.engine.collision.rigid.Bodies;
import nephele.engine.math.BitHash;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/**
 * The world state: everything that can change in a level besides the player. Parts that the level does not use are
 * their empty constants, which cost nothing and do not enter the hash.
 *
 * @param bodies in the level's order
 * @param portals the level's fixed portals in its order, then the shot ones in the order of their first shots: an index
 *     once given keeps its meaning
 * @param shots the indices of the gun's portals
 * @param holding what the player holds
 * @param trace what the last tick did
 */
public record Changeable(Bodies bodies, Portals portals, Shots shots, Holding holding, TickTrace trace) {
    public static final Changeable NOTHING =
            new Changeable(Bodies.NONE, Portals.NONE, Shots.NONE, Holding.NOTHING, TickTrace.NONE);

    Changeable with(Bodies changed) {
        return changed == bodies ? this : new Changeable(changed, portals, shots, holding, trace);
    }

    Changeable with(Holding changed) {
        return new Changeable(bodies, portals, shots, changed, trace);
    }

    Changeable with(Portals changed, Shots now) {
        return new Changeable(bodies, changed, now, holding, trace);
    }

    Changeable with(TickTrace changed) {
        return changed == trace ? this : new Changeable(bodies, portals, shots, holding, changed);
    }

    long hash(long seed) {
        long hash = bodies.size() == 0 ? seed : bodies.hash(seed);
        hash = portals.size() == 0 ? hash : joined(hash, portals);
        return trace.hash(holding.hash(shots.hash(hash)));
    }

    /** Joins the portals' centres, frames and links to a hash; apertures belong to the level and never change. */
    private static long joined(long seed, Portals portals) {
        long hash = BitHash.join(seed, portals.size());
        for (int i = 0; i < portals.size(); i++) {
            Portal portal = portals.portal(i);
            hash = BitHash.join(BitHash.join(hash, portals.partner(i)), portal.centre());
            hash = BitHash.join(hash, portal.frame().up());
            hash = BitHash.join(hash, portal.frame().back());
        }
        return hash;
    }
}
