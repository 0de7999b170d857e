package nephele.engine.collision.rigid;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/**
 * The static world with which each body collides. A body active on a portal, from the first to the last contact with
 * it, collides with the geometry behind it instead of the wall around its opening.
 */
public interface Surroundings {
    /** Returns the portals of this tick; bodies wake when they differ from those of the tick before. */
    Portals portals();

    /**
     * Returns a bit mask of the portals on which a shape is active.
     *
     * @param at the shape's origin; portals with the origin behind their plane do not count
     * @param way displacement that it is about to make
     */
    long active(RoundedHull shape, Vector3dc at, Vector3dc way);

    /** Returns the static geometry for a shape active on these portals. The same mask gives the same object. */
    CollisionWorld around(long active);

    /** Returns the static world opened at its portals. */
    static Surroundings of(SeamedWorld world) {
        return new Surroundings() {
            @Override
            public Portals portals() {
                return world.portals();
            }

            @Override
            public long active(RoundedHull shape, Vector3dc at, Vector3dc way) {
                return world.active(shape, at, way);
            }

            @Override
            public CollisionWorld around(long active) {
                return world.around(active);
            }
        };
    }

    /** Returns one world for every shape, without portals. */
    static Surroundings of(CollisionWorld world) {
        return new Surroundings() {
            @Override
            public Portals portals() {
                return Portals.NONE;
            }

            @Override
            public long active(RoundedHull shape, Vector3dc at, Vector3dc way) {
                return 0;
            }

            @Override
            public CollisionWorld around(long active) {
                return world;
            }
        };
    }
}
