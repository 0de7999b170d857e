package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Characters and bodies push each other, also through portals, and stop fast bodies. */
class CharacterAndBodiesTest {
    private static Vec3 v(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    /** The body gains the momentum that the character loses. */
    @Test
    void pushGivesAndTakesTheSameMomentum() {
        BodyScene scene = new BodyScene().weightless();
        int box = scene.add(new Body.Box("box", v(1, 0, 0), v(0.5, 0.5, 0.5), 20, null, 0, 0));
        BodyInfluences.Character player = new BodyInfluences.Character(0.3, 1.8, 80);
        scene.influences.add(player);
        player.move(new Vector3d(0.45, 0, 0), new Vector3d(2, 0, 0));
        scene.start();
        scene.tick(1 / 120.0);
        assertEquals(20 * scene.velocity(box).x, -player.impulse().x(), 1e-9);
        assertEquals(1.6, scene.velocity(box).x, 0.02, "an inelastic hit: 80 · 2 / 100");
    }

    /** Through a portal, the body behind it moves away from its wall. */
    @Test
    void pushesThroughAPortal() {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-10, -10, -1, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(v(0, 0, 0), v(0, 0, 1), v(30, 0, 0), v(-1, 0, 0), 1.2, 2.1);
        int box = scene.add(new Body.Box("box", v(29.65, 0, 0), v(0.5, 0.5, 0.5), 20, null, 0, 0));
        BodyInfluences.Character player = new BodyInfluences.Character(0.3, 1.8, 80);
        scene.influences.add(player);
        player.move(new Vector3d(0, 0, 0.2), new Vector3d(0, 0, -2));
        scene.start();
        scene.tick(1 / 120.0);
        assertEquals(-1.6, scene.velocity(box).x, 0.05);
        assertEquals(20 * 1.6, player.impulse().z(), 1, "held back in its own space");
    }

    /** A ball that moves several times the character's thickness in a tick does not pass it. */
    @Test
    void nothingFliesThroughACharacter() {
        BodyScene scene = new BodyScene().weightless();
        int ball = scene.add(new Body.Sphere("ball", v(-2, 0, 0), 0.1, 1, null, 0, 0));
        BodyInfluences.Character player = new BodyInfluences.Character(0.3, 1.8, 80);
        scene.influences.add(player);
        player.move(new Vector3d(0, 0, 0), new Vector3d());
        scene.start().velocity(ball, v(150, 0, 0), Vec3.ZERO).run(0.5, 60);
        assertTrue(scene.centre(ball).x < 0, "before it");
    }

    /** A tick that takes the ball through the portal does not take it past the obstacle behind. */
    @Test
    void nothingFliesThroughWhatStandsBeyondAPortal() {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-10, -10, -1, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(v(0, 0, 0), v(0, 0, 1), v(30, 0, 0), v(-1, 0, 0), 1.2, 2.1);
        int ball = scene.add(new Body.Sphere("ball", v(0, 0, 0.5), 0.1, 1, null, 0, 0));
        scene.add(new Body.Box("block", v(28.5, 0, 0), v(0.2, 2, 2), 1000, null, 0, 0));
        scene.start().velocity(ball, v(0, 0, -200), Vec3.ZERO).run(0.1, 60);
        assertTrue(scene.centre(ball).x > 28.5 && scene.centre(ball).x < 30, "between both: " + scene.centre(ball));
    }

    /** A body slides on a floor of tiles as on one of one piece. */
    @Test
    void seamsOfTilesStopNothing() {
        BodyScene tiles = new BodyScene();
        for (int i = -2; i < 20; i++) {
            tiles.box(i, -1, -5, i + 1, 0, 5);
        }
        BodyScene whole = new BodyScene().box(-2, -1, -5, 20, 0, 5);
        for (BodyScene scene : List.of(tiles, whole)) {
            scene.add(new Body.Box("box", v(0, 0.25, 0.1), v(0.6, 0.5, 0.7), 3, null, 0.1, 0));
            scene.start().velocity(0, v(5, 0, 0.3), Vec3.ZERO).run(3, 120);
        }
        assertEquals(0, tiles.centre(0).distance(whole.centre(0)), 0.02);
        assertTrue(tiles.centre(0).x > 8);
    }
}
