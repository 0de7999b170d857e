package nephele.workshop.prove.bodies;

import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** The solids and other bodies that a body touches, in a world without portals. */
final class Supports {
    static final double TOUCHING_METRES = .005;
    /** The index that stands for a solid. */
    static final int SOLID = -1;

    private final BodyTable table;
    private final CollisionWorld world;
    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final Vector3d centre = new Vector3d();
    private final Vector3d normal = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    Supports(BodyTable table, CollisionWorld world) {
        this.table = table;
        this.world = world;
    }

    /** Receives the contacts of a body. */
    @FunctionalInterface
    interface Visitor {
        /**
         * @param other index of a body, or {@link #SOLID}
         * @param normal of unit length, away from the touched object; valid during the call
         */
        void touches(int other, Vector3d normal);
    }

    void each(Bodies bodies, int body, Visitor visitor) {
        RoundedHull hull = table.hull(body, bodies.orientation(body, turn));
        bodies.centre(body, centre);
        world.overlapping(around(hull, centre), near);
        for (int i = 0; i < near.size(); i++) {
            visit(hull, world.collider(near.get(i)), SOLID, visitor);
        }
        for (int i = 0; i < bodies.size(); i++) {
            if (i != body) {
                Vector3d at = bodies.centre(i, new Vector3d());
                visit(hull, table.collider(i, at, bodies.orientation(i, turn)), i, visitor);
            }
        }
    }

    private static Aabb around(RoundedHull hull, Vector3d at) {
        return new Aabb(
                        at.x + hull.least(0),
                        at.y + hull.least(1),
                        at.z + hull.least(2),
                        at.x + hull.greatest(0),
                        at.y + hull.greatest(1),
                        at.z + hull.greatest(2))
                .grown(TOUCHING_METRES);
    }

    private void visit(RoundedHull hull, Collider against, int other, Visitor visitor) {
        separation.measure(hull, centre.x, centre.y, centre.z, against);
        if (separation.metres() < TOUCHING_METRES) {
            visitor.touches(other, normal.set(separation.normal()));
        }
    }
}
