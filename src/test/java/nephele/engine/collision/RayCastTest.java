package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Rays that start on surfaces neither hit them again nor leak through walls of 1 mm. */
class RayCastTest {
    private static final double WALL = 0.001;

    private static CollisionWorld room(double at) {
        ConvexPolyhedron[] walls = new ConvexPolyhedron[6];
        double[][] six = {
            {at + 1, at - 1, at - 1, at + 1 + WALL, at + 1, at + 1},
            {at - 1 - WALL, at - 1, at - 1, at - 1, at + 1, at + 1},
            {at - 1, at + 1, at - 1, at + 1, at + 1 + WALL, at + 1},
            {at - 1, at - 1 - WALL, at - 1, at + 1, at - 1, at + 1},
            {at - 1, at - 1, at + 1, at + 1, at + 1, at + 1 + WALL},
            {at - 1, at - 1, at - 1 - WALL, at + 1, at + 1, at - 1}
        };
        for (int i = 0; i < 6; i++) {
            double[] w = six[i];
            walls[i] = ConvexPolyhedron.box(new Aabb(w[0], w[1], w[2], w[3], w[4], w[5]));
        }
        return Solids.world(walls);
    }

    @Test
    void aRayBouncesInARoomForever() {
        for (double at : new double[] {0, 1000, 1 << 20}) {
            CollisionWorld world = room(at);
            RayCast cast = new RayCast();
            var random = new SplittableRandom(7);
            Vector3d place = new Vector3d(at);
            int last = -1;
            for (int i = 0; i < 10_000; i++) {
                Vector3d direction = Solids.direction(random);
                Plane on = last < 0
                        ? null
                        : world.collider(last)
                                .shape()
                                .faces()
                                .get(cast.face(lastRay))
                                .plane();
                if (on != null && direction.dot(on.nx(), on.ny(), on.nz()) < 0) {
                    direction.negate();
                }
                Ray ray = new Ray(place.x, place.y, place.z, direction.x, direction.y, direction.z);
                assertTrue(cast.cast(world, ray, 100), "leak in bounce " + i + " from " + place);
                assertFalse(cast.collider() == last, "self-hit in bounce " + i);
                last = cast.collider();
                lastRay = ray;
                Vec3 hit = ray.at(cast.distance());
                place.set(hit.x(), hit.y(), hit.z());
                assertTrue(place.distance(at, at, at) < 1.8, "left the room");
            }
        }
    }

    private Ray lastRay;

    /** A ray from within rounding of a face hits it at once inwards, and never outwards. */
    @Test
    void aRayFromASurfaceSeesItOnlyInwards() {
        CollisionWorld world = Solids.world(Solids.box(2, 2, WALL));
        RayCast cast = new RayCast();
        var random = new SplittableRandom(8);
        for (int i = 0; i < 10_000; i++) {
            double z = WALL / 2 + random.nextInt(-4, 5) * Math.ulp(1.0);
            Vector3d d = Solids.direction(random);
            Ray ray = new Ray(1.8 * random.nextDouble() - 0.9, 0, z, d.x, d.y, d.z);
            boolean inwards = d.z < 0 && Math.abs(d.z) > 1e-3;
            if (inwards) {
                assertTrue(cast.cast(world, ray, 10), "leak " + i);
                assertEquals(0, cast.distance(), 1e-9);
            } else if (d.z > 0) {
                assertFalse(cast.cast(world, ray, 10), "self-hit " + i);
            }
        }
    }

    @Test
    void tellsFaceAndDistance() {
        CollisionWorld world = Solids.world(Solids.box(2, 2, 2));
        RayCast cast = new RayCast();
        Ray ray = new Ray(5, 0.5, 0, -1, 0, 0);
        assertTrue(cast.cast(world, ray, 100));
        assertEquals(4, cast.distance(), 1e-15);
        assertEquals(0, cast.face(ray));
        assertFalse(cast.cast(world, ray, 3.9));
        assertFalse(cast.cast(world, new Ray(0, 0, 0, 1, 0, 0), 100), "from inside");
        assertFalse(cast.cast(world, new Ray(5, 0, 0, 0, 0, 0), 100));
        assertFalse(cast.cast(world, new Ray(5, 0, 0, Double.NaN, 0, 0), 100));
    }
}
