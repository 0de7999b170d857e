package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Depenetration from thousands of solids succeeds in bounded CPU time. */
class CrowdedDepenetrationTest {
    private static final RoundedHull BALL = RoundedHull.sphere(0.3);
    private static final long MOST_CPU_NANOSECONDS = 2_000_000_000L;

    private static CollisionWorld boxes(int count, IntFunction<Aabb> box) {
        List<Collider> colliders = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            colliders.add(new Collider("box " + i, ConvexPolyhedron.box(box.apply(i))));
        }
        return new CollisionWorld(colliders);
    }

    private static Vector3d wayOut(CollisionWorld world, Vector3d from) {
        var depenetration = new Depenetration();
        var way = new Vector3d();
        assertTrue(depenetration.find(world, BALL, from, way));
        assertTrue(depenetration.isFree(world, BALL, new Vector3d(from).add(way)));
        return way;
    }

    /** Shifts the boxes by 1 mm each, so that every push ends in others. */
    @Test
    void outOfTenThousandOverlappingBoxesThereIsAWay() {
        CollisionWorld world = boxes(
                10_000, i -> Aabb.around(new Vec3((i % 100 - 50) * 1e-3, 0, (i / 100 - 50) * 1e-3), new Vec3(1, 1, 1)));
        assertSoon(() -> assertTrue(wayOut(world, new Vector3d(0.01, 0.02, 0)).length() <= 0.9));
    }

    /** The shortest displacement is upwards, except for the gaps of 1 mm. */
    @Test
    void outOfTenThousandSmallBoxesThereIsAWay() {
        CollisionWorld world = boxes(
                10_000,
                i -> Aabb.around(
                        new Vec3((i % 100 - 49.5) * 0.011, 0, (i / 100 - 49.5) * 0.011), new Vec3(0.01, 0.01, 0.01)));
        assertSoon(() -> {
            Vector3d way = wayOut(world, new Vector3d(0, 0.1, 0));
            assertEquals(0, way.distance(0, 0.2 + 0.005 + Sweep.SKIN_METRES, 0), 5e-3);
        });
    }

    /** A gap too narrow for the sphere is not used. */
    @Test
    void alongTheAxesItIsByTheFirstGapThatIsWideEnough() {
        assertEquals(-1.8 - Sweep.SKIN_METRES, alongTheAxes(0.2), 1e-9);
        assertEquals(0.8 + Sweep.SKIN_METRES, alongTheAxes(0.7), 1e-9);
    }

    /** Returns the displacement out of the first of two plates, from beside its middle. */
    private static double alongTheAxes(double gap) {
        CollisionWorld world = boxes(2, i -> Aabb.around(new Vec3(i * (2 + gap), 0, 0), new Vec3(2, 10, 10)));
        var displacement = new Vector3d();
        double metres = new Depenetration().alongAxes(world, BALL, new Vector3d(0.5, 0, 0), displacement);
        assertEquals(metres, displacement.length(), 0);
        return displacement.x();
    }

    private static void assertSoon(Runnable work) {
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadCpuTime();
        work.run();
        assertTrue(threads.getCurrentThreadCpuTime() - before < MOST_CPU_NANOSECONDS);
    }
}
