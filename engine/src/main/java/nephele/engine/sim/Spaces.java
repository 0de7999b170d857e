package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.portal.Portals;

/**
 * A cache of the last requested portal space: it is rebuilt only when the portals change, never in a tick without a
 * shot.
 */
final class Spaces {
    private final CollisionWorld statics;
    private PortalSpace last;

    Spaces(CollisionWorld statics) {
        this.statics = statics;
        last = new PortalSpace(statics, Portals.NONE);
    }

    PortalSpace of(Portals portals) {
        if (last.portals() != portals) {
            last = new PortalSpace(statics, portals);
        }
        return last;
    }
}
