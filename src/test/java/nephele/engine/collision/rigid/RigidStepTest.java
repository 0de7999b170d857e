package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies without portals: free flight, rest, friction, restitution, sleep, speed and invalid numbers. */
@Execution(ExecutionMode.CONCURRENT)
class RigidStepTest {
    private static Vec3 v(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    /** Free flight is the exact parabola at any tick rate. */
    @ParameterizedTest
    @ValueSource(doubles = {30, 60, 120, 240})
    void freeFlightIsTheParabola(double rate) {
        BodyScene scene = new BodyScene();
        int ball = scene.add(new Body.Sphere("ball", v(0, 100, 0), 0.2, 3, null, 0.6, 0));
        scene.start().velocity(ball, v(3, 4, -2), Vec3.ZERO).run(2, rate);
        assertEquals(0, scene.centre(ball).distance(6, 108 - 9.81 * 2, -4), 1e-10);
        assertEquals(0, scene.velocity(ball).distance(3, 4 - 9.81 * 2, -2), 1e-10);
    }

    /** A cube with 50 rad/s keeps its angular velocity and its orientation to 1e-9. */
    @Test
    void spinningCubeKeepsMomentumAndEnergy() {
        BodyScene scene = new BodyScene().weightless();
        int cube = scene.cube(0.5, Vec3.ZERO);
        scene.start().velocity(cube, Vec3.ZERO, v(30, 0, 40)).run(60, 120);
        assertEquals(0, scene.spin(cube).distance(30, 0, 40), 50 * 1e-9);
        assertEquals(1, scene.orientation(cube).lengthSquared(), 1e-12);
        Quaterniond turned =
                new Quaterniond(0.6 * Math.sin(25 * 60.0), 0, 0.8 * Math.sin(25 * 60.0), Math.cos(25 * 60.0));
        assertEquals(1, Math.abs(turned.dot(scene.orientation(cube))), 1e-9, "the turn itself is exact");
    }

    /** An uneven box tumbles (Dzhanibekov effect) with constant angular momentum and its energy in a narrow band. */
    @Test
    void tumblingBoxKeepsMomentumAndEnergy() {
        BodyScene scene = new BodyScene().weightless();
        int box = scene.add(new Body.Box("box", Vec3.ZERO, v(0.2, 0.6, 1.1), 2, null, 0.6, 0));
        scene.start().velocity(box, Vec3.ZERO, v(0.01, 10, 0.02));
        Vector3d momentum = momentum(scene, box);
        double energy = momentum.dot(scene.spin(box)) / 2;
        double flipped = 1;
        for (int i = 0; i < 2400; i++) {
            scene.tick(1 / 120.0);
            assertEquals(0, momentum(scene, box).distance(momentum), 1e-9 * momentum.length());
            assertEquals(1, momentum(scene, box).dot(scene.spin(box)) / 2 / energy, 1e-6);
            flipped = Math.min(flipped, scene.orientation(box).transform(new Vector3d(0, 1, 0)).y);
        }
        assertTrue(flipped < -0.9, "the middle axis is unstable");
    }

    private static Vector3d momentum(BodyScene scene, int box) {
        Quaterniond q = scene.orientation(box);
        Vector3d spin = q.transformInverse(scene.spin(box));
        double m = 2 / 12.0;
        spin.mul(m * (0.36 + 1.21), m * (0.04 + 1.21), m * (0.04 + 0.36));
        return q.transform(spin);
    }

    /** A tower of ten cubes stays within 5 mm and half a degree. The proof `bodies` runs it for a minute. */
    @ParameterizedTest
    @ValueSource(doubles = {30, 60, 120, 240})
    void towerStands(double rate) {
        BodyScene scene = new BodyScene().floor();
        for (int i = 0; i < 10; i++) {
            scene.cube(1, v(0, 0.5 + i, 0));
        }
        scene.start().run(5, rate);
        for (int i = 0; i < 10; i++) {
            assertEquals(0, scene.centre(i).distance(0, 0.5 + i, 0), 0.005, "box " + i);
            double angle = 2 * Math.toDegrees(Math.acos(Math.min(1, Math.abs(scene.orientation(i).w))));
            assertEquals(0, angle, 0.5, "box " + i);
        }
    }

    /**
     * On a slope of 30°, a box with friction below tan 30° slides at the acceleration of Coulomb's law; with more it
     * stays.
     */
    @ParameterizedTest
    @CsvSource({"0.3, true", "0.55, true", "0.6, false"})
    void slidesOnASlopeByCoulomb(double friction, boolean slides) {
        double angle = Math.toRadians(30);
        BodyScene scene = new BodyScene()
                .box(-500, -1, -50, 500, 0, 50)
                .gravity(v(9.81 * Math.sin(angle), -9.81 * Math.cos(angle), 0));
        int box = scene.add(new Body.Box("box", v(0, 0.25, 0), v(1, 0.5, 1), 4, null, friction, 0));
        scene.start().run(2, 120);
        double acceleration = 9.81 * (Math.sin(angle) - friction * Math.cos(angle));
        if (slides) {
            assertEquals(acceleration * 2, scene.velocity(box).x, 0.02 * acceleration * 2);
        } else {
            assertEquals(0, scene.centre(box).x, 0.005);
        }
    }

    /** A box that spins flat on the floor is slowed by friction about the normal. */
    @Test
    void spinningOnTheFloorRubs() {
        BodyScene scene = new BodyScene().floor();
        int box = scene.add(new Body.Box("box", v(0, 0.05, 0), v(1, 0.1, 1), 2, null, 0.3, 0));
        scene.start().run(0.2, 120).velocity(box, Vec3.ZERO, v(0, 5, 0)).run(0.2, 120);
        double slowed = 5 - scene.spin(box).y;
        // With even pressure: μ g · mean distance from the centre / (side² / 6); four corners are farther from it.
        double even = 0.3 * 9.81 * 0.3826 * 6 * 0.2;
        assertTrue(slowed > even && slowed < 2 * even, "slowed by " + slowed + ", " + even + " if evenly pressed");
        scene.run(3, 120);
        assertEquals(0, scene.spin(box).length(), 1e-3);
    }

    /** A bounce returns its share e of the speed: the next apex is e² as high. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.9, 1})
    void bouncesBackToItsShareOfTheHeight(double restitution) {
        BodyScene scene = new BodyScene().floor();
        int ball = scene.add(new Body.Sphere("ball", v(0, 2.3, 0), 0.3, 1, null, 0.6, restitution));
        scene.start();
        double fall = Math.sqrt(2 * 2 / 9.81);
        scene.run(fall + 0.03, 120);
        double apex = 0;
        for (int i = 0; i < 120; i++) {
            scene.tick(1 / 120.0);
            apex = Math.max(apex, scene.centre(ball).y - 0.3);
        }
        assertEquals(2 * restitution * restitution, apex, 0.05 * restitution + 1e-3);
    }

    @Test
    void sleepsAndCostsNothingUntilSomebodyComes() {
        BodyScene scene = new BodyScene().floor();
        int low = scene.cube(1, v(0, 0.5, 0));
        int high = scene.cube(1, v(0, 1.5, 0));
        int ball = scene.add(new Body.Sphere("ball", v(0, 30, 0), 0.3, 1, null, 0.6, 0));
        scene.start().run(1.5, 120);
        assertTrue(scene.now.isAsleep(low) && scene.now.isAsleep(high));
        boolean woke = false;
        for (int i = 0; i < 360; i++) {
            scene.tick(1 / 120.0);
            woke |= !scene.now.isAsleep(low);
        }
        assertTrue(woke, "the ball fell on them");
        scene.run(2, 120);
        assertTrue(scene.now.isAsleep(low) && scene.now.isAsleep(high), "rest again");
        assertEquals(2.3, scene.centre(ball).y, 2e-3);
        assertTrue(scene.now.isAsleep(ball), "on top");
        Bodies rest = scene.now;
        scene.tick(1 / 120.0);
        assertSame(rest, scene.now);
    }

    /** Removes the lower of two sleeping bodies: the upper one falls. */
    @Test
    void whoLeantOnWhatIsTakenAwayFalls() {
        BodyScene scene = new BodyScene().floor();
        int low = scene.cube(1, v(0, 0.5, 0));
        int high = scene.cube(1, v(0, 1.5, 0));
        scene.start().run(2, 120);
        assertTrue(scene.now.isAsleep(high));
        scene.set(low, BodyState.resting(v(10, 0.5, 0))).run(1, 120);
        assertEquals(0.5, scene.centre(high).y, 2e-3);
    }

    /** Bodies of up to 10 km/s, also thin ones, do not pass a wall of a centimetre. */
    @ParameterizedTest
    @CsvSource({"1000, 0.5, 0.5", "1000, 0.001, 0.4", "30, 0.001, 0.4", "3, 0.001, 0.4", "10000, 0.05, 0.05"})
    void nothingTunnels(double speed, double thick, double wide) {
        for (double rate : new double[] {30, 120, 240}) {
            BodyScene scene = new BodyScene().weightless().box(10, -5, -5, 10.01, 5, 5);
            int body = scene.add(new Body.Box("body", v(0, 0, 0), v(thick, wide, wide), 1, null, 0.6, 0));
            scene.start().velocity(body, v(speed, 0.01 * speed, 0), Vec3.ZERO);
            for (int i = 0; i < 14 / speed * rate + 20; i++) {
                scene.tick(1 / rate);
                assertTrue(scene.centre(body).x < 10.005, rate + ": at " + scene.centre(body));
            }
        }
    }

    /** A fast body hits its target for any shapes: momentum is conserved and the target gets a share of it. */
    @ParameterizedTest
    @CsvSource({"box, box", "box, ball", "ball, box", "ball, ball"})
    void bulletsHitBodies(String bullet, String target) {
        for (double speed : new double[] {20, 300, 1000}) {
            BodyScene scene = new BodyScene().weightless();
            scene.add(body(bullet, v(0, 0, 0), 0.05));
            scene.add(body(target, v(7.3, 0.01, 0), 0.2));
            scene.start().velocity(0, v(speed, 0, 0), Vec3.ZERO).run(10 / speed + 0.1, 120);
            double hit = scene.velocity(1).x;
            assertEquals(speed, scene.velocity(0).x + hit, 1e-9 * speed, "momentum");
            assertTrue(hit > 0.3 * speed, speed + ": hit with " + hit);
        }
    }

    private static Body body(String kind, Vec3 at, double half) {
        return kind.equals("ball")
                ? new Body.Sphere("ball" + at, at, half, 1, null, 0, 0)
                : new Body.Box("box" + at, at, v(2 * half, 2 * half, 2 * half), 1, null, 0, 0);
    }

    /** Bodies that fly one behind the other at one speed do not slow each other. */
    @Test
    void flyingInFileHoldsNobodyUp() {
        BodyScene scene = new BodyScene().weightless();
        for (int i = 0; i < 5; i++) {
            scene.cube(0.2, v(0.25 * i, 0, 0));
        }
        scene.start();
        for (int i = 0; i < 5; i++) {
            scene.velocity(i, v(40, 0, 0), Vec3.ZERO);
        }
        scene.run(1, 120);
        for (int i = 0; i < 5; i++) {
            assertEquals(0, scene.centre(i).distance(40 + 0.25 * i, 0, 0), 1e-9);
        }
    }

    /** A body with a non-finite motion is frozen, and the body on it continues. */
    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300})
    void notANumberFreezesTheBodyAlone(double wrong) {
        BodyScene scene = new BodyScene().floor();
        int bad = scene.cube(1, v(0, 0.5, 0));
        int good = scene.cube(1, v(0, 1.6, 0));
        scene.start().velocity(bad, v(wrong, 0, 0), Vec3.ZERO).run(1, 120);
        assertTrue(scene.now.isFrozen(bad));
        assertFalse(scene.now.isFrozen(good));
        assertEquals(1, scene.now.frozen());
        assertEquals(0, scene.centre(bad).distance(0, 0.5, 0), 0);
        assertEquals(1.5, scene.centre(good).y, 2e-3, "stands on the frozen one");
    }

    /** Bodies that overlap at the start separate slowly. */
    @Test
    void overlapsPartWithoutExplosion() {
        BodyScene scene = new BodyScene().floor();
        for (int i = 0; i < 8; i++) {
            scene.cube(1, v(0.1 * i, 0.3 + 0.2 * i, 0.05 * i));
        }
        scene.start();
        for (int i = 0; i < 600; i++) {
            scene.tick(1 / 120.0);
            for (int body = 0; body < 8; body++) {
                assertTrue(
                        scene.velocity(body).length() < (i < 60 ? 3 : 11), "tick " + i + ": " + scene.velocity(body));
            }
        }
        for (int body = 0; body < 8; body++) {
            assertTrue(scene.centre(body).y > 0.49, "above the floor: " + scene.centre(body));
        }
    }

    /** The result is the same to the bit, whatever the working set was used for before. */
    @Test
    void dependsOnNothingButItsArguments() {
        BodyScene scene = heap();
        scene.run(1, 120);
        Bodies middle = scene.now;
        scene.run(1, 120);
        long end = scene.now.hash(7);
        scene.now = middle;
        assertEquals(end, scene.run(1, 120).now.hash(7), "the same step again");
        assertEquals(end, heap().run(2, 120).now.hash(7), "another step from the start");
        BodyScene other = heap();
        other.velocity(3, v(1e-15, 0, 0), Vec3.ZERO);
        assertNotEquals(end, other.run(2, 120).now.hash(7));
    }

    private static BodyScene heap() {
        BodyScene scene = new BodyScene().floor().box(-2, 0, -2, 2, 0.3, -1.5);
        for (int i = 0; i < 30; i++) {
            Vec3 at = v(0.3 * (i % 4) - 0.5, 0.6 + 0.5 * i, 0.2 * (i % 3) - 0.3);
            switch (i % 3) {
                case 0 -> scene.cube(0.6, at);
                case 1 -> scene.add(new Body.Sphere("s" + i, at, 0.3, 1, null, 0.4, 0.3));
                default -> scene.add(new Body.Capsule("c" + i, at, 0.2, 0.9, 1, null, 0.6, 0));
            }
        }
        return scene.start();
    }

    @Test
    void heapComesToRest() {
        // After a longer time, the fastest ball rolls off the floor's edge.
        BodyScene scene = heap().run(9, 120);
        for (int body = 0; body < scene.now.size(); body++) {
            assertTrue(scene.centre(body).y > 0.15, body + " is above the floor: " + scene.centre(body));
            // Round bodies keep rolling: there is no rolling friction.
            double allowed = body % 3 == 0 ? 0.5 : 6;
            assertTrue(scene.velocity(body).length() < allowed, body + ": " + scene.velocity(body));
        }
    }

    @Test
    void levelWithoutBodiesCostsNothing() {
        BodyScene scene = new BodyScene().floor().start();
        Bodies before = scene.now;
        scene.tick(1 / 120.0);
        assertSame(before, scene.now);
    }

    /** A plate in a slit thinner than itself, with opposite overlaps side by side, is not thrown out. */
    @Test
    void contradictoryOverlapsThrowNothingAway() {
        BodyScene scene = new BodyScene().box(-1, -1, -1, 0.3, 0, 1).box(0.2985, 0.03, -1, 2, 1, 1);
        int plate =
                scene.add(new Body.Box("plate", new Vec3(0.1, 0.015, 0), new Vec3(1, 0.04, 0.02), 50, null, 0.6, 0));
        scene.start();
        Vector3d last = scene.centre(plate);
        for (int i = 0; i < 120; i++) {
            scene.tick(1 / 120.0);
            double moved = scene.centre(plate).distance(last);
            assertTrue(moved < 0.04, moved + " m in tick " + i);
            last = scene.centre(plate);
        }
    }
}
