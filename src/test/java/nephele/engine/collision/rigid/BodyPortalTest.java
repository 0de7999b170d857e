package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies pass through portals and touch each other through them without loss, gain or leak. */
@Execution(ExecutionMode.CONCURRENT)
class BodyPortalTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private static Vec3 v(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    /** Returns two rooms with a portal pair at floor level, in the walls at z = 0 and x = 30. */
    private static BodyScene rooms(double width, double height) {
        return new BodyScene()
                .floor()
                .box(-10, 0, -1, 10, 5, 0)
                .box(30, 0, -10, 31, 5, 10)
                .pair(v(0, height / 2, 0), v(0, 0, 1), v(30, height / 2, 0), v(-1, 0, 0), width, height);
    }

    /** A rod of 1 mm crosses once, and leaves in the same way at every tick rate. */
    @ParameterizedTest
    @CsvSource({"0.001, 30", "0.001, 240", "1, 60", "10, 30", "100, 120", "1000, 30", "1000, 240"})
    void rodCrossesOnce(double speed, double rate) {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-50, -50, -1, 50, 50, 0)
                .box(-50, -50, 2000, 50, 50, 2001)
                .pair(v(0, 0, 0), v(0, 0, 1), v(10, 0, 2000), v(0, 0, -1), 1.2, 2.1);
        int rod = scene.add(new Body.Box("rod", v(0, 0, 0), v(0.001, 0.001, 0.4), 1, null, 0.6, 0));
        scene.start();
        double before = Math.max(0.0004, Math.min(0.3, speed));
        scene.set(rod, new BodyState(v(0.1, 0.3, before), new Quaterniond(), v(0, 0, -speed), Vec3.ZERO));
        int ticks = (int) Math.ceil(2.5 * before / speed * rate);
        int crossings = 0;
        for (int i = 0; i < ticks; i++) {
            scene.tick(1 / rate);
            crossings += scene.now.crossings(rod);
        }
        assertEquals(1, crossings);
        assertEquals(0, scene.centre(rod).distance(10.1, 0.3, 2000 + before - speed * ticks / rate), 1e-3);
        assertEquals(0, scene.velocity(rod).distance(0, 0, -speed), 1e-9 * speed);
    }

    /** A body passes several portals in one tick, in order, and keeps its velocity. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 8})
    void manyPortalsInOneTick(int hops) {
        BodyScene scene = new BodyScene().weightless();
        for (int i = 0; i < hops; i++) {
            // Each exit faces the next entry from one metre.
            scene.pair(v(0, 10 * i, 0), v(0, 0, 1), v(0, 10 * (i + 1), 1), v(0, 0, -1), 2, 2);
        }
        int ball = scene.add(new Body.Sphere("ball", v(0.3, 0.2, 1), 0.1, 1, null, 0.6, 0));
        scene.start();
        scene.velocity(ball, v(0, 0, -60 * (hops + 0.5)), v(1, 2, 3));
        scene.tick(1 / 60.0);
        assertEquals(hops, scene.now.crossings(ball));
        assertEquals(0, scene.centre(ball).distance(0.3, 10 * hops + 0.2, 0.5), 1e-9);
        assertEquals(0, scene.velocity(ball).distance(0, 0, -60 * (hops + 0.5)), 1e-9);
    }

    /** The speed of an endless fall follows v² = 2 g h, without loss or gain at the portals. */
    @Test
    void endlessFallGathersSpeedExactly() {
        BodyScene scene = new BodyScene()
                .box(-5, -1, -5, 5, 0, 5)
                .box(-5, 3, -5, 5, 4, 5)
                .pair(v(0, 0, 0), UP, v(0, 3, 0), DOWN, 1.2, 1.2);
        int cube = scene.cube(0.5, v(0, 1.5, 0));
        scene.start();
        long passes = 0;
        while (passes < 10_000) {
            scene.tick(1 / 120.0);
            passes += scene.now.crossings(cube);
        }
        double fall = 1.5 - scene.centre(cube).y + 3.0 * passes;
        assertEquals(1, scene.velocity(cube).lengthSquared() / (2 * 9.81 * fall), 1e-9);
    }

    /** Between two floor portals the apex is constant to 1e-6 m. */
    @ParameterizedTest
    @ValueSource(doubles = {30, 60, 120, 240})
    void floorToFloorKeepsTheApex(double rate) {
        BodyScene scene = new BodyScene().floor().pair(v(0, 0, 0), UP, v(10, 0, 0), UP, 1.2, 1.2);
        int cube = scene.cube(0.5, v(0, 2, 0));
        scene.start();
        int passes = 0;
        double worst = 0;
        while (passes < 1000) {
            scene.tick(1 / rate);
            passes += scene.now.crossings(cube);
            double apex = scene.centre(cube).y + scene.velocity(cube).lengthSquared() / (2 * 9.81);
            worst = Math.max(worst, Math.abs(apex - 2));
        }
        assertTrue(worst <= 1e-6, "apex off by " + worst);
    }

    /** An oblique fall keeps its sideways speed. */
    @Test
    void obliqueFallKeepsItsSidewaysSpeed() {
        BodyScene scene = new BodyScene()
                .box(-500, -1, -5, 500, 0, 5)
                .box(-500, 3, -5, 500, 4, 5)
                .pair(v(0, 0, 0), UP, v(0, 3, 0), DOWN, 800, 4);
        int cube = scene.cube(0.5, v(0, 1.5, 0));
        scene.start().velocity(cube, v(0.7, 0, 0), Vec3.ZERO);
        scene.run(20, 120);
        assertEquals(0.7, Math.abs(scene.velocity(cube).x), 1e-12);
    }

    /** A box that slides through a portal at floor level moves as through an open doorway. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.3", "1.5, 0.9", "3, 0.5", "6, 0.9"})
    void slidingThroughIsAsThroughADoorway(double speed, double size) {
        BodyScene portal = rooms(1.2, 2.1);
        BodyScene doorway = new BodyScene()
                .floor()
                .box(-10, 0, -1, -0.6, 5, 0)
                .box(0.6, 0, -1, 10, 5, 0)
                .box(-0.6, 2.1, -1, 0.6, 5, 0);
        Body box = new Body.Box("box", v(0, size / 2, 1), v(size, size, size), 1, null, 0.05, 0);
        for (BodyScene scene : List.of(portal, doorway)) {
            scene.add(box);
            scene.start().velocity(0, v(0, 0, -speed), Vec3.ZERO);
        }
        for (int i = 0; i < 300; i++) {
            portal.tick(1 / 120.0);
            doorway.tick(1 / 120.0);
            Vector3d there = portal.centre(0);
            Vector3d here = doorway.centre(0);
            Vector3d mapped = there.x > 10 ? new Vector3d(-there.z, there.y, there.x - 30) : there;
            assertEquals(0, mapped.distance(here), 1e-3, "tick " + i + " " + there + " " + here);
        }
    }

    /** The rim holds a box that is too large. */
    @ParameterizedTest
    @CsvSource({"1.19, true", "1.21, false", "3, false"})
    void passesOnlyIfItFits(double width, boolean passes) {
        BodyScene scene = rooms(1.2, 2.1);
        int box = scene.add(new Body.Box("box", v(0, 0.5, 1), v(width, 0.9, 0.4), 1, null, 0.02, 0));
        scene.start().velocity(box, v(0, 0, -2), Vec3.ZERO).run(2, 120);
        assertEquals(passes, scene.centre(box).x > 10, "at " + scene.centre(box));
        if (!passes) {
            assertTrue(scene.centre(box).z > 0.19, "held before the wall, not at " + scene.centre(box));
        }
    }

    /** A sleeping body wakes when a portal opens under it. */
    @Test
    void sleeperFallsWhenAPortalOpensUnderIt() {
        BodyScene scene = new BodyScene().floor().box(5, 2, -5, 6, 8, 5);
        int cube = scene.cube(0.5, v(0, 0.25, 0));
        scene.start().run(2, 120);
        assertTrue(scene.now.isAsleep(cube));
        Portals open = new Portals(
                List.of(
                        BodyScene.portal(v(0, 0, 0), UP, 1.2, 1.2),
                        BodyScene.portal(v(5, 5, 0), v(-1, 0, 0), 1.2, 1.2)),
                List.of(1, 0));
        scene.open(open).run(0.6, 120);
        assertFalse(scene.now.isAsleep(cube));
        assertTrue(scene.centre(cube).x > 2, "came out of the wall, not at " + scene.centre(cube));
    }

    /** A plank in both portals of a pair, side by side, gains no energy. */
    @Test
    void plankInBothPortalsOfAPairStaysCalm() {
        BodyScene scene = new BodyScene().floor().pair(v(0, 0, 0), UP, v(1.3, 0, 0), UP, 1.2, 1.2);
        int plank = scene.add(new Body.Box("plank", v(0.65, 0.5, 0), v(2, 0.1, 0.4), 1, null, 0.6, 0));
        scene.start();
        double highest = 0;
        for (int i = 0; i < 600; i++) {
            scene.tick(1 / 120.0);
            double energy = scene.velocity(plank).lengthSquared() / 2 + 9.81 * scene.centre(plank).y;
            highest = Math.max(highest, energy);
        }
        assertTrue(highest <= 9.81 * 0.5 + 1e-6, "energy " + highest);
        assertTrue(scene.centre(plank).y > -0.2 && scene.centre(plank).isFinite());
    }

    /** A body in portals that face each other 0.2 m apart touches itself and gains no energy. */
    @ParameterizedTest
    @ValueSource(doubles = {0.11, 0.16, 0.19})
    void bodyThatTouchesItselfGainsNoEnergy(double size) {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-5, -1, -5, 5, 0, 5)
                .box(-5, 0.2, -5, 5, 1, 5)
                .pair(v(0, 0, 0), UP, v(0, 0.2, 0), DOWN, 1.2, 1.2);
        int cube = scene.cube(size, v(0, 0.1, 0));
        scene.start().velocity(cube, v(0, 0.3, 0), v(2, 1, 3));
        double inertia = size * size / 6;
        double before = energy(scene, cube, inertia);
        double last = before;
        for (int i = 0; i < 1200; i++) {
            scene.tick(1 / 120.0);
            double now = energy(scene, cube, inertia);
            assertTrue(now <= before * (1 + 1e-9), "tick " + i + ": " + now + " from " + before);
            assertTrue(now <= last + before * 1e-3, "tick " + i + ": " + now + " from " + last);
            last = now;
        }
        assertTrue(last <= before * (1 + 1e-9), last + " from " + before);
        assertEquals(
                size > 0.2 / Math.sqrt(3), last < 0.99 * before, "a cube of " + size + " meets itself when it turns");
        assertTrue(scene.centre(cube).isFinite());
    }

    private static double energy(BodyScene scene, int body, double inertia) {
        return scene.velocity(body).lengthSquared() / 2
                + inertia * scene.spin(body).lengthSquared() / 2;
    }

    /** With portals in both walls of a corner, a body neither leaks nor gets stuck. */
    @Test
    void cornerOfTwoPortals() {
        BodyScene scene = new BodyScene()
                .floor()
                .box(-10, 0, -1, 10, 5, 0)
                .box(-1, 0, 0, 0, 5, 10)
                .pair(v(0.6, 1.05, 0), v(0, 0, 1), v(0, 1.05, 0.6), v(1, 0, 0), 1.2, 2.1);
        int cube = scene.add(new Body.Box("cube", v(1, 0.25, 1), v(0.5, 0.5, 0.5), 1, null, 0.02, 0));
        scene.start().velocity(cube, v(-2, 0, -1.9), Vec3.ZERO);
        for (int i = 0; i < 600; i++) {
            scene.tick(1 / 120.0);
            Vector3d p = scene.centre(cube);
            assertTrue(p.x > -1e-6 && p.z > -1e-6 && p.y > 0.2, "leaked to " + p);
        }
        scene.velocity(cube, v(2, 0, 2), Vec3.ZERO).run(0.5, 120);
        assertTrue(scene.centre(cube).distance(0, 0.25, 0) > 0.8, "stuck at " + scene.centre(cube));
    }

    /** A cube that enters a portal pushes the cube in front of the exit, and momentum is shared. */
    @Test
    void cubesPushEachOtherThroughAPortal() {
        BodyScene scene = rooms(1.2, 2.1);
        int pushing = scene.add(new Body.Box("pushing", v(0, 0.4, 0.5), v(0.8, 0.8, 0.8), 1, null, 0, 0));
        int pushed = scene.add(new Body.Box("pushed", v(29.5, 0.4, 0), v(0.8, 0.8, 0.8), 1, null, 0, 0));
        scene.start().velocity(pushing, v(0, 0, -1), Vec3.ZERO).run(0.5, 120);
        assertEquals(-0.5, scene.velocity(pushed).x, 0.05, "pushed away from its wall by an inelastic hit");
        assertEquals(-0.5, scene.velocity(pushing).z, 0.05, "slowed by as much");
    }

    /** A body behind the wall does not touch a body that goes through the portal in it. */
    @Test
    void whoIsBehindTheWallIsNotMet() {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-10, -10, -0.05, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(v(0, 0, 0), v(0, 0, 1), v(30, 0, 0), v(-1, 0, 0), 1.2, 2.1);
        int passing = scene.cube(0.8, v(0, 0, 1));
        int behind = scene.cube(0.8, v(0.1, 0.1, -0.5));
        scene.start().velocity(passing, v(0, 0, -1), Vec3.ZERO).run(2, 120);
        assertEquals(0, scene.centre(passing).distance(29, 0, 0), 1e-9);
        assertEquals(0, scene.centre(behind).distance(0.1, 0.1, -0.5), 0);
    }

    /** Orientation and angular velocity are mapped through a portal. */
    @Test
    void spinIsMapped() {
        BodyScene scene = rooms(1.2, 2.1).weightless();
        int ball = scene.add(new Body.Sphere("ball", v(0, 1, 1), 0.2, 1, null, 0.6, 0));
        int free = scene.add(new Body.Sphere("free", v(0, 10, 1), 0.2, 1, null, 0.6, 0));
        scene.start();
        scene.velocity(ball, v(0, 0, -2), v(1, 2, 3));
        scene.velocity(free, v(0, 0, -2), v(1, 2, 3)).run(1, 120);
        // Enters along −z and leaves along −x: a quarter turn about y.
        assertEquals(0, scene.spin(ball).distance(3, 2, -1), 1e-9);
        Quaterniond turned = new Quaterniond().rotationY(Math.PI / 2).mul(scene.orientation(free));
        assertEquals(1, Math.abs(turned.dot(scene.orientation(ball))), 1e-12);
    }

    /** A body half-way through a portal rests without a change of any bit. */
    @Test
    void restsHalfWayThrough() {
        BodyScene scene = rooms(1.2, 2.1);
        int box = scene.add(new Body.Box("box", v(0, 0.25, 0.1), v(0.5, 0.5, 0.8), 3, null, 0.6, 0));
        scene.start().run(2, 120);
        assertTrue(scene.now.isAsleep(box));
        assertEquals(0, scene.centre(box).distance(0, 0.25, 0.1), 1e-3);
        Bodies before = scene.now;
        scene.run(1, 120);
        assertEquals(before.hash(0), scene.now.hash(0));
        Portals same =
                new Portals(List.of(scene.portals().portal(0), scene.portals().portal(1)), List.of(1, 0));
        scene.open(same).run(1, 120);
        assertEquals(before.hash(0), scene.now.hash(0), "by value, wherever the state goes on");
    }

    /** A cube over a floor portal that is too small for it rests on the rim. */
    @Test
    void restsOnTheRim() {
        BodyScene scene = new BodyScene().floor().pair(v(0, 0, 0), UP, v(10, 0, 0), UP, 0.6, 0.6);
        int cube = scene.cube(0.8, v(0.05, 0.5, 0));
        scene.start().run(3, 120);
        assertTrue(scene.now.isAsleep(cube));
        assertEquals(0, scene.centre(cube).distance(0.05, 0.4, 0), 2e-3);
    }

    /** Ten kilometres from the origin a passage equals that at the origin within 1e-6 m. */
    @Test
    void farOutIsAsHere() {
        Vector3d there = null;
        for (double far : new double[] {0, 10_000}) {
            BodyScene scene = new BodyScene()
                    .box(far - 50, -1, -50, far + 50, 0, 50)
                    .box(far - 10, 0, -1, far + 10, 5, 0)
                    .pair(v(far, 1.05, 0), v(0, 0, 1), v(far + 20, 0, 0), UP, 1.2, 2.1);
            int box = scene.add(new Body.Box("box", v(far, 0.25, 1), v(0.5, 0.5, 0.5), 1, null, 0.1, 0));
            scene.start().velocity(box, v(0, 0, -3), Vec3.ZERO).run(0.75, 120);
            Vector3d out = scene.centre(box).sub(far, 0, 0);
            assertTrue(out.x > 19, "out of the floor, not at " + out);
            there = there == null ? out : there;
            assertEquals(0, out.distance(there), 1e-6);
        }
    }
}
