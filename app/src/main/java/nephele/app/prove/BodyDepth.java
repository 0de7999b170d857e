package nephele.app.prove;

import nephele.engine.collision.Recovery;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.Bodies;
import nephele.engine.collision.rigid.BodyTable;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** How deep the bodies of a pile reach into what is solid in the opened world, and how far they are from each other. */
final class BodyDepth {
    private static final Vector3d STILL = new Vector3d();

    private final DroppedPile pile;
    private final SeamedWorld world;
    private final BodyTable table;
    private final Recovery recovery = new Recovery();
    private final Separation separation = new Separation();
    private final Vector3d centre = new Vector3d();
    private final Vector3d other = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    BodyDepth(DroppedPile pile, SeamedWorld world) {
        this.pile = pile;
        this.world = world;
        table = pile.table();
    }

    /** Metres of the body that is deepest in a solid, or farthest out of the room; 0 for none. */
    double inSolids(Bodies bodies) {
        double deepest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            RoundedHull hull = table.hull(i, bodies.orientation(i, turn));
            bodies.centre(i, centre);
            double depth = recovery.depth(world.around(world.active(hull, centre, STILL)), hull, centre);
            deepest = Math.max(deepest, Math.max(depth, outside(centre)));
        }
        return deepest;
    }

    private double outside(Vector3d c) {
        double aside = Math.max(Math.abs(c.x), Math.abs(c.z)) - DroppedPile.HALF_ROOM_METRES;
        return Math.max(aside, Math.max(-c.y, c.y - pile.heightMetres()));
    }

    /** Metres of the deepest overlap of two bodies on the same side of every portal; 0 for none. */
    double inBodies(Bodies bodies) {
        double deepest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            for (int j = 0; j < i; j++) {
                deepest = Math.max(deepest, -gapMetres(bodies, i, j));
            }
        }
        return deepest;
    }

    /** Between the surfaces of two bodies, negative where they overlap. */
    double gapMetres(Bodies bodies, int a, int b) {
        bodies.centre(b, other);
        var solid = table.collider(b, other, bodies.orientation(b, turn));
        var hull = table.hull(a, bodies.orientation(a, turn));
        bodies.centre(a, centre);
        separation.measure(hull, centre.x, centre.y, centre.z, solid);
        return separation.metres();
    }
}
