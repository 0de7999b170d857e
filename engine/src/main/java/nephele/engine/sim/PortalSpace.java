package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.rigid.Surroundings;
import nephele.engine.math.Ray;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/**
 * The space that follows from the static geometry and the portals of a tick. Portals with an obstructed exit are closed
 * in it.
 */
final class PortalSpace {
    private final SeamedWorld seamed;
    private final Portals portals;
    private final Surroundings surroundings;
    private final RayCast cast = new RayCast();

    PortalSpace(CollisionWorld statics, Portals given) {
        seamed = SeamedWorld.of(statics, given);
        portals = seamed.portals();
        surroundings = Surroundings.of(seamed);
    }

    SeamedWorld seamed() {
        return seamed;
    }

    /** Returns the fraction of a way that is free of static solids; portals are ignored. */
    double free(Vector3dc from, Vector3dc way) {
        var ray = new Ray(from.x(), from.y(), from.z(), way.x(), way.y(), way.z());
        return cast.cast(seamed.statics(), ray, 1) ? cast.distance() : 1;
    }

    Portals portals() {
        return portals;
    }

    /** Returns the same space in the form that the rigid-body solver uses. */
    Surroundings surroundings() {
        return surroundings;
    }
}
