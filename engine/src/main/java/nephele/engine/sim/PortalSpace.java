package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.rigid.Surroundings;
import nephele.engine.math.Ray;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/** What follows from the level and the portals of a tick. Its portals are closed where the exit is no place to come out. */
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

    /** How much of a way is free of solids, portals aside. */
    double free(Vector3dc from, Vector3dc way) {
        var ray = new Ray(from.x(), from.y(), from.z(), way.x(), way.y(), way.z());
        return cast.cast(seamed.statics(), ray, 1) ? cast.distance() : 1;
    }

    Portals portals() {
        return portals;
    }

    /** The same as the bodies' solver asks for it. */
    Surroundings surroundings() {
        return surroundings;
    }
}
