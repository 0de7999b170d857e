package nephele.engine.collision.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A character pushes bodies and is pushed, bodies stand in its way, and both through portals. */
class CharacterAndBodiesTest {
    private static final RoundedHull PLAYER = RoundedHull.uprightCapsule(0.3, 1.8);

    private static Vec3 v(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    /** Momentum: what the body gets the character gives. */
    @Test
    void pushGivesAndTakesTheSameMomentum() {
        BodyScene scene = new BodyScene().weightless();
        int box = scene.add(new Body.Box("box", v(1, 0, 0), v(0.5, 0.5, 0.5), 20, null, 0, 0));
        Influences.Character player = new Influences.Character(0.3, 1.8, 80);
        scene.influences.add(player);
        player.move(new Vector3d(0.44, 0, 0), new Vector3d(2, 0, 0));
        scene.start();
        scene.tick(1 / 120.0);
        assertEquals(20 * scene.velocity(box).x, -player.impulse().x(), 1e-9);
        assertEquals(1.6, scene.velocity(box).x, 0.02, "an inelastic hit: 80 · 2 / 100");
    }

    /** The same through a portal: the body beyond moves away from its wall. */
    @Test
    void pushesThroughAPortal() {
        BodyScene scene = new BodyScene()
                .weightless()
                .box(-10, -10, -1, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(v(0, 0, 0), v(0, 0, 1), v(30, 0, 0), v(-1, 0, 0), 1.2, 2.1);
        int box = scene.add(new Body.Box("box", v(29.65, 0, 0), v(0.5, 0.5, 0.5), 20, null, 0, 0));
        Influences.Character player = new Influences.Character(0.3, 1.8, 80);
        scene.influences.add(player);
        player.move(new Vector3d(0, 0, 0.21), new Vector3d(0, 0, -2));
        scene.start();
        scene.tick(1 / 120.0);
        assertEquals(-1.6, scene.velocity(box).x, 0.05);
        assertEquals(20 * 1.6, player.impulse().z(), 1, "held back in its own space");
    }

    @Test
    void bodyStandsInTheWayOfASweep() {
        BodyTable table = new BodyTable(List.of(
                new Body.Box("box", v(3, 0.9, 0), v(1, 1, 1), 1, null, 0.6, 0),
                new Body.Sphere("ball", v(0, 0.9, 4), 0.5, 1, null, 0.6, 0)));
        BodyCast cast = new BodyCast(table);
        Bodies bodies = table.start();
        BodyScene empty = new BodyScene().start();
        Vector3d from = new Vector3d(0, 0.9, 0);
        assertTrue(cast.cast(bodies, empty.portals(), PLAYER, 0, from, new Vector3d(5, 0, 0), -1));
        assertEquals((2.2 - Sweep.SKIN_METRES) / 5, cast.fraction(), 1e-9);
        assertEquals(0, cast.normal().distance(-1, 0, 0), 1e-9);
        assertEquals(0, cast.body());
        assertTrue(cast.cast(bodies, empty.portals(), PLAYER, 0, from, new Vector3d(0, 0, 5), -1));
        assertEquals((3.2 - Sweep.SKIN_METRES) / 5, cast.fraction(), 1e-9);
        assertFalse(cast.cast(bodies, empty.portals(), PLAYER, 0, from, new Vector3d(0, 0, 5), 1), "but for it");
        assertFalse(cast.cast(bodies, empty.portals(), PLAYER, 0, from, new Vector3d(-5, 0, 0), -1));
    }

    @Test
    void bodyBeyondAPortalStandsInTheWay() {
        BodyScene scene = new BodyScene()
                .box(-10, -10, -1, 10, 10, 0)
                .box(30, -10, -10, 31, 10, 10)
                .pair(v(0, 0, 0), v(0, 0, 1), v(30, 0, 0), v(-1, 0, 0), 1.2, 2.1);
        Body box = new Body.Box("box", v(29, 0, 0), v(0.5, 0.5, 0.5), 20, null, 0, 0);
        Body behind = new Body.Box("behind", v(0, 0, -0.5), v(0.5, 0.5, 0.5), 20, null, 0, 0);
        scene.add(box);
        scene.add(behind);
        scene.start();
        BodyCast cast = new BodyCast(new BodyTable(List.of(box, behind)));
        Vector3d from = new Vector3d(0, 0, 0.6);
        assertTrue(cast.cast(scene.now, scene.portals(), PLAYER, 1, from, new Vector3d(0, 0, -2), -1));
        assertEquals(0, cast.body(), "what is behind the wall is not there");
        assertEquals(1, cast.portal(), "the one that the box is before");
        assertEquals((0.6 + 0.75 - 0.3 - Sweep.SKIN_METRES) / 2, cast.fraction(), 1e-9);
        assertEquals(0, cast.normal().distance(0, 0, 1), 1e-9);
    }

    /** A floor of tiles is as smooth as one of one piece. */
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
