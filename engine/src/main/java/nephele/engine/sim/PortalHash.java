package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/** Portals as part of a state's hash: places, frames and links. Apertures are the level's and never change. */
final class PortalHash {
    private PortalHash() {}

    static long join(long seed, Portals portals) {
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
