package nephele.engine.collision.rigid;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/**
 * The static world as each body meets it. Who is active on a portal, from first touch to last leave, meets what lies
 * beyond it instead of the wall that it is in.
 */
public interface Surroundings {
    /** The portals that are open at this tick; bodies wake where they differ from those of the tick before. */
    Portals portals();

    /**
     * The portals that a shape is active on, as a bit mask.
     *
     * @param at the shape's origin; a portal behind whose plane it is does not count
     * @param way how far it is about to move
     */
    long active(RoundedHull shape, Vector3dc at, Vector3dc way);

    /** What a shape meets that is active on these portals. The same mask gives the same object. */
    CollisionWorld around(long active);

    /** The static world with its portals' seams. */
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

    /** One world for everybody and no portal. */
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
