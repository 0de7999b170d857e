package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Depenetration gives displacements worked out by hand and verified by measurement. */
class DepenetrationTest {
    private static final double SKIN = Sweep.SKIN_METRES;
    private static final RoundedHull BALL = RoundedHull.sphere(0.3);

    private final Depenetration depenetration = new Depenetration();
    private final Vector3d push = new Vector3d();

    @Test
    void theWayOutOfABoxIsByTheNearestFaceAndEndsTheSkinBeforeIt() {
        CollisionWorld world = Solids.world(Solids.box(4, 2, 6));
        Vector3d at = new Vector3d(0.5, 0.25, 0);
        assertEquals(0.75 + 0.3, depenetration.depth(world, BALL, at), 1e-12);
        assertFalse(depenetration.isFree(world, BALL, at));
        assertTrue(depenetration.find(world, BALL, at, push));
        assertEquals(0, push.distance(0, 0.75 + 0.3 + SKIN, 0), 1e-12, push::toString);
        assertTrue(depenetration.find(world, BALL, at.add(push), push));
        assertEquals(0, push.length(), "free already");
    }

    /** In a corner a box ends the skin away from both the floor and the wall. */
    @Test
    void theWayOutOfACornerLeadsOutOfAllItsSolids() {
        RoundedHull box = RoundedHull.box(new Vec3(0.5, 0, 0), new Vec3(0, 0.5, 0), new Vec3(0, 0, 0.5));
        double[] floor = {-9, -9, -9, 9, 0, 9};
        double[] wall = {-9, 0, -9, 0, 9, 9};
        CollisionWorld world = PortalPairs.boxes(Vec3.ZERO, floor, wall);
        assertTrue(depenetration.find(world, box, new Vector3d(0.4, 0.47, 3), push));
        assertEquals(0, push.distance(0.1 + SKIN, 0.03 + SKIN, 0), 1e-9, push::toString);
    }

    /** For any solid, the end is free, and the skin away from the one solid that was overlapped. */
    @Test
    void whereItEndsIsFree() {
        var random = new SplittableRandom(9);
        var separation = new Separation();
        int met = 0;
        for (int i = 0; i < 500; i++) {
            ConvexPolyhedron solid = Solids.any(random);
            CollisionWorld world = Solids.world(solid);
            Vector3d at = Solids.point(random, 0.6);
            double depth = depenetration.depth(world, BALL, at);
            assertTrue(depenetration.find(world, BALL, at, push), "pair " + i);
            separation.measure(BALL, at.x + push.x, at.y + push.y, at.z + push.z, world.collider(0));
            if (depth > 0) {
                met++;
                assertEquals(SKIN, separation.metres(), 1e-8, "pair " + i);
                assertEquals(depth + SKIN, push.length(), 1e-8, "pair " + i);
            }
        }
        assertTrue(met > 200, "met " + met);
    }
}
