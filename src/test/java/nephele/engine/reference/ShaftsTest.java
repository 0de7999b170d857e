package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import nephele.engine.level.Brush;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class ShaftsTest {
    private static final int RAYS = 100_000;
    private static final int BOXES = 150;
    private static final Vec3 LIGHT = new Vec3(3.2, 1.1, -4.7);
    private static final Vector3d TOWARDS_SUN = new Vector3d(0.3, 0.9, 0).normalize();

    private final SplittableRandom random = new SplittableRandom(7);
    private final TracedItems surfaces = surfaces();
    private final Shafts.ShadowRays shadows = new Shafts.ShadowRays(surfaces, shafts(Long.MAX_VALUE));
    private int blocked;

    /** Returns boxes: some adjacent, some far away, some so thin that few rays of a shaft intersect them. */
    private TracedItems surfaces() {
        TestLevel stage = new TestLevel().skyLight();
        for (int i = 0; i < BOXES; i++) {
            stage.box("grey", new Vec3(within(8), within(8), within(8)), new Vec3(size(), size(), size()));
        }
        List<Brush> brushes = stage.level().solids().stream().map(Brush::of).toList();
        return new TracedItems(StaticShapes.of(brushes), List.of(), 0, List.of(), List.of());
    }

    private Shafts shafts(long mostBytes) {
        Vec3 sunwards = Vec3.of(TOWARDS_SUN);
        List<Function<Aabb, ShaftShape>> lights = new ArrayList<>();
        lights.add(from -> ShaftShape.along(sunwards, sunwards, from));
        lights.add(from -> ShaftShape.to(LIGHT, from));
        return new Shafts(surfaces, lights, mostBytes);
    }

    private double within(double metres) {
        return metres * (2 * random.nextDouble() - 1);
    }

    private double size() {
        return Math.pow(10, -2 + 2.6 * random.nextDouble());
    }

    /** Returns a position; one in four is on the side of a cube. */
    private Vector3d place() {
        Vector3d place = new Vector3d(within(9), within(9), within(9));
        return random.nextInt(4) == 0 ? place.setComponent(random.nextInt(3), random.nextInt(-9, 10)) : place;
    }

    private void agree(boolean isBlocked, Vector3d origin, Vector3d direction, double limit, int except) {
        Ray ray = TracedItems.ray(origin, direction);
        assertEquals(surfaces.blocker(ray, limit, except) >= 0, isBlocked, () -> origin + " along " + direction);
        blocked += isBlocked ? 1 : 0;
    }

    @Test
    void theSunIsBlockedByWhatIsInTheWay() {
        for (int i = 0; i < RAYS; i++) {
            Vector3d from = place();
            int except = random.nextInt(BOXES);
            boolean isBlocked = shadows.isBlocked(0, from, TOWARDS_SUN, Double.POSITIVE_INFINITY, except);
            agree(isBlocked, from, TOWARDS_SUN, Double.POSITIVE_INFINITY, except);
        }
        assertTrue(blocked > RAYS / 10 && blocked < RAYS * 9 / 10, () -> blocked + " blocked");
    }

    @Test
    void aLightIsBlockedByWhatIsBeforeIt() {
        for (int i = 0; i < RAYS; i++) {
            Vector3d from = place();
            Vector3d way = LIGHT.toVector().sub(from);
            int except = random.nextInt(BOXES);
            agree(shadows.isBlocked(1, from, way, 1, except), from, way, 1, except);
        }
        assertTrue(blocked > RAYS / 10 && blocked < RAYS * 9 / 10, () -> blocked + " blocked");
    }

    @Test
    void theSkyIsBlockedInEveryDirectionByWhatIsInTheWay() {
        for (int i = 0; i < RAYS; i++) {
            Vector3d from = place();
            // Small whole numbers are directions on the borders of patches.
            Vector3d way = random.nextBoolean()
                    ? new Vector3d(random.nextInt(-2, 3), random.nextInt(-2, 3), random.nextInt(-2, 3))
                    : new Vector3d(within(1), within(1), within(1));
            if (way.lengthSquared() > 0) {
                way.normalize();
                int except = random.nextInt(BOXES);
                boolean isBlocked = shadows.isSkyBlocked(from, way, except);
                agree(isBlocked, from, way, Double.POSITIVE_INFINITY, except);
            }
        }
        assertTrue(blocked > RAYS / 10 && blocked < RAYS * 9 / 10, () -> blocked + " blocked");
    }

    @Test
    void farFromTheOriginEveryRayAsksForItself() {
        Vector3d from = new Vector3d(3e6, 0, 0);
        Vector3d way = new Vector3d(-1, 0, 0);
        boolean isBlocked = shadows.isSkyBlocked(from, way, -1);
        agree(isBlocked, from, way, Double.POSITIVE_INFINITY, -1);
    }

    @Test
    void shaftsBeyondWhatMayBeKeptAreForgotten() {
        Shafts plenty = shafts(Long.MAX_VALUE);
        Shafts few = shafts(1);
        for (Shafts shafts : List.of(plenty, few)) {
            Shafts.Cube cube = shafts.cube(new Vector3d(), null);
            assertSame(cube, shafts.cube(new Vector3d(), null));
            shafts.shaft(cube, shafts.patch(TOWARDS_SUN));
            assertEquals(shafts == plenty, cube == shafts.cube(new Vector3d(), null));
        }
    }

    @Test
    void whatWasForgottenIsAnsweredAlike() {
        Shafts.ShadowRays forgetful = new Shafts.ShadowRays(surfaces, shafts(10_000));
        for (int i = 0; i < RAYS / 10; i++) {
            Vector3d from = place();
            Vector3d way = new Vector3d(within(1), within(1), within(1)).normalize();
            agree(forgetful.isSkyBlocked(from, way, -1), from, way, Double.POSITIVE_INFINITY, -1);
        }
    }
}
