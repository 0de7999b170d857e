package nephele.workshop.prove.bodies;

import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Measures the penetration of bodies into the static world opened at the portals, and into each other. */
final class BodyDepth {
    private static final Vector3d STILL = new Vector3d();

    private final BodyTable table;
    private final PortalWorld world;
    private final Depenetration depenetration = new Depenetration();
    private final Separation separation = new Separation();
    private final Vector3d centre = new Vector3d();
    private final Vector3d other = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    BodyDepth(BodyTable table, PortalWorld world) {
        this.table = table;
        this.world = world;
    }

    /** Returns the body's deepest penetration into a solid, in metres; 0 for none. */
    double inSolids(Bodies bodies, int body) {
        RoundedHull hull = table.hull(body, bodies.orientation(body, turn));
        bodies.centre(body, centre);
        return Math.max(0, depenetration.depth(world.openedFor(world.active(hull, centre, STILL)), hull, centre));
    }

    /**
     * Returns the body's deepest penetration into another body, in metres; 0 for none. Contacts through a portal do not
     * count.
     */
    double inBodies(Bodies bodies, int body) {
        double deepest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            deepest = i == body ? deepest : Math.max(deepest, -gapMetres(bodies, body, i));
        }
        return deepest;
    }

    /** Returns the distance between the surfaces of two bodies, negative where they overlap. */
    double gapMetres(Bodies bodies, int a, int b) {
        bodies.centre(b, other);
        var solid = table.collider(b, other, bodies.orientation(b, turn));
        var hull = table.hull(a, bodies.orientation(a, turn));
        bodies.centre(a, centre);
        separation.measure(hull, centre.x, centre.y, centre.z, solid);
        return separation.metres();
    }
}
