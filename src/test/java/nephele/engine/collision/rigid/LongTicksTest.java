package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ticks longer than 1/120 s are stepped in parts, without visible effect. */
final class LongTicksTest {
    private static Vec3 v(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    /** A body that goes through two portals in one tick reports both, in the order of passage. */
    @Test
    void crossingsOfAllPartsAreTold() {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-10, -10, -1, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(v(0, 0, 0), v(0, 0, 1), v(30, 0, 0), v(-1, 0, 0), 1.2, 2.1)
                .box(18, -10, -10, 19, 10, 10)
                .box(-10, -10, 40, 10, 10, 41)
                .pair(v(19, 0, 0), v(1, 0, 0), v(0, 0, 40), v(0, 0, -1), 1.2, 2.1);
        int ball = scene.add(new Body.Sphere("ball", v(0, 0, 0.5), 0.05, 1, null, 0, 0));
        scene.start().velocity(ball, v(0, 0, -240), Vec3.ZERO);
        scene.tick(1 / 20.0);
        assertEquals(2, scene.now.crossings(ball));
        assertEquals(0, scene.now.crossing(ball, 0));
        assertEquals(2, scene.now.crossing(ball, 1));
        scene.tick(1 / 1000.0);
        assertEquals(0, scene.now.crossings(ball));
    }

    /** The impulse between a character and a body is the same in a tick of one part and of six. */
    @ParameterizedTest
    @ValueSource(ints = {120, 60, 20})
    void charactersGiveWhatTheyTake(int rate) {
        BodyScene scene = new BodyScene().weightless();
        int box = scene.add(new Body.Box("box", v(1, 0, 0), v(0.5, 0.5, 0.5), 20, null, 0, 0));
        BodyInfluences.Character player = new BodyInfluences.Character(0.3, 1.8, 80);
        scene.influences.add(player);
        player.move(new Vector3d(0.45, 0, 0), new Vector3d(2, 0, 0));
        scene.start();
        scene.tick(1.0 / rate);
        assertEquals(20 * scene.velocity(box).x, -player.impulse().x(), 1e-9);
        assertEquals(1.6, scene.velocity(box).x, 1e-6, "an inelastic hit: 80 · 2 / 100");
    }

    /** Two bodies that rest beside each other without contact force fall asleep. */
    @ParameterizedTest
    @ValueSource(ints = {20, 120, 700})
    void neighboursDoNotWakeEachOther(int rate) {
        BodyScene scene = new BodyScene().floor();
        scene.add(new Body.Box("a", v(0, 0.1, 0), v(0.2, 0.2, 0.2), 1, null, 0.6, 0));
        scene.add(new Body.Box("b", v(0.2005, 0.15, 0), v(0.2, 0.3, 0.2), 1, null, 0.6, 0));
        scene.start().run(2, rate);
        assertTrue(scene.now.isAsleep(0) && scene.now.isAsleep(1));
    }

    /** A ball that rolls past a sleeping body, a centimetre away, does not wake it; one that rolls at it does. */
    @ParameterizedTest
    @ValueSource(ints = {20, 120})
    void onlyWhatReachesASleeperWakesIt(int rate) {
        BodyScene scene = new BodyScene().floor();
        int box = scene.add(new Body.Box("box", v(0, 0.25, 0), v(0.5, 0.5, 0.5), 3, null, 0.6, 0));
        int past = scene.add(new Body.Sphere("past", v(0.36, 0.1, -2), 0.1, 1, null, 0.6, 0));
        int at = scene.add(new Body.Sphere("at", v(0, 0.1, -4), 0.1, 1, null, 0.6, 0));
        scene.start().run(1, rate);
        assertTrue(scene.now.isAsleep(box));
        scene.velocity(past, v(0, 0, 2), v(20, 0, 0)).velocity(at, v(0, 0, 2), v(20, 0, 0));
        for (int tick = 0; tick < 1.5 * rate; tick++) {
            scene.tick(1.0 / rate);
            assertTrue(scene.now.isAsleep(box), "in tick " + tick);
        }
        assertTrue(scene.centre(past).z > 0.5);
        scene.run(1, rate);
        assertTrue(scene.centre(box).z > 0.01);
    }
}
