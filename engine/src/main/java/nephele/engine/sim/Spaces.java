package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.portal.Portals;

/** The space of the portals that were asked for last: it is built when they change, never in a tick without a shot. */
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
