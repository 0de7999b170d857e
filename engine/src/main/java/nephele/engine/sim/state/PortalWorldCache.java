package nephele.engine.sim.state;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.portal.Portals;

/**
 * A cache of the last requested portal space: it is rebuilt only when the portals change, never in a tick without a
 * shot.
 */
public final class PortalWorldCache {
    private final CollisionWorld statics;
    private PortalWorld last;

    public PortalWorldCache(CollisionWorld statics) {
        this.statics = statics;
        last = PortalWorld.of(statics, Portals.NONE);
    }

    public PortalWorld of(Portals portals) {
        if (last.portals() != portals) {
            last = PortalWorld.of(statics, portals);
        }
        return last;
    }
}
