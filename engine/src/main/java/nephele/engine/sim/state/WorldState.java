package nephele.engine.sim.state;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.math.Hash64;
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
 * @param exit whether the level has ended
 * @param fall where the player last stood; only with the assist that uses it
 * @param arrival the portal that the player came out of; only with the assist that uses it
 */
public record WorldState(
        Bodies bodies,
        Portals portals,
        GunPortals shots,
        HeldBody holding,
        TickTrace trace,
        ExitState exit,
        FallState fall,
        Arrival arrival) {
    public static final WorldState NOTHING = new WorldState(
            Bodies.NONE,
            Portals.NONE,
            GunPortals.NONE,
            HeldBody.NOTHING,
            TickTrace.NONE,
            ExitState.NONE,
            FallState.NONE,
            Arrival.NONE);

    public WorldState with(Bodies changed) {
        return changed == bodies ? this : new WorldState(changed, portals, shots, holding, trace, exit, fall, arrival);
    }

    public WorldState with(HeldBody changed) {
        return new WorldState(bodies, portals, shots, changed, trace, exit, fall, arrival);
    }

    public WorldState with(Portals changed, GunPortals now) {
        return new WorldState(bodies, changed, now, holding, trace, exit, fall, arrival);
    }

    public WorldState with(TickTrace changed) {
        return changed == trace ? this : new WorldState(bodies, portals, shots, holding, changed, exit, fall, arrival);
    }

    /** Returns this state with another state of the exits. */
    public WorldState with(ExitState changed) {
        return changed == exit ? this : new WorldState(bodies, portals, shots, holding, trace, changed, fall, arrival);
    }

    /** Returns this state with another memory of falls. */
    public WorldState with(FallState changed) {
        return changed == fall ? this : new WorldState(bodies, portals, shots, holding, trace, exit, changed, arrival);
    }

    /** Returns this state with another arrival. */
    public WorldState with(Arrival changed) {
        return changed == arrival ? this : new WorldState(bodies, portals, shots, holding, trace, exit, fall, changed);
    }

    public long hash(long seed) {
        long hash = bodies.size() == 0 ? seed : bodies.hash(seed);
        hash = portals.size() == 0 ? hash : joined(hash, portals);
        return arrival.hash(fall.hash(exit.hash(trace.hash(holding.hash(shots.hash(hash))))));
    }

    /** Joins the portals' centres, frames and links to a hash; apertures belong to the level and never change. */
    private static long joined(long seed, Portals portals) {
        long hash = Hash64.combine(seed, portals.size());
        for (int i = 0; i < portals.size(); i++) {
            Portal portal = portals.portal(i);
            hash = Hash64.combine(Hash64.combine(hash, portals.partner(i)), portal.centre());
            hash = Hash64.combine(hash, portal.frame().up());
            hash = Hash64.combine(hash, portal.frame().back());
        }
        return hash;
    }
}
