package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.portal.Portals;

/**
 * A cache of the last requested portal space: it is rebuilt only when the portals change, never in a tick without a
 * shot.
 */
final class Spaces {
    private final CollisionWorld statics;
    private SeamedWorld last;

    Spaces(CollisionWorld statics) {
        this.statics = statics;
        last = SeamedWorld.of(statics, Portals.NONE);
    }

    SeamedWorld of(Portals portals) {
        if (last.portals() != portals) {
            last = SeamedWorld.of(statics, portals);
        }
        return last;
    }
}
