package nephele.engine.sim.player;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The push of a walker on the bodies that it runs into. */
class BodyPushesTest {
    private static final double TICK = 1 / 120.0;
    private static final Vector3d NORTH = new Vector3d(0, 0, -1);
    private static final Vector3d AT_REST = new Vector3d();

    private static PlayerMotion standing() {
        var player = new PlayerMotion(new CharacterMover(new BodyObstacles(new BodyTable(List.of()))));
        player.load(PlayerState.standing(Vec3.ZERO, ViewAngles.ofDegrees(0, 0)));
        return player;
    }

    private static Vector3d push(Vector3d intent, Vector3d... normals) {
        var pushes = new BodyPushes();
        pushes.intent(intent);
        for (Vector3d normal : normals) {
            pushes.met(normal, AT_REST);
        }
        pushes.settle(standing(), TICK);
        return new Vector3d(pushes.push());
    }

    /** Two contacts with the same normal are pushed no harder than one. */
    @Test
    void whatIsMetTwiceIsPushedOnce() {
        Vector3d once = push(NORTH, new Vector3d(0, 0, 1));
        assertEquals(0, once.x);
        assertEquals(-400 * TICK / PlayerDimensions.MASS_KILOGRAMS, once.z, 1e-15);
        assertEquals(once, push(NORTH, new Vector3d(0, 0, 1), new Vector3d(0, 0, 1)));
    }

    @Test
    void whatIsLeftBehindIsNotPushed() {
        assertEquals(AT_REST, push(NORTH, new Vector3d(0, 0, -1)));
        assertEquals(AT_REST, push(NORTH, new Vector3d(1, 0, 0)));
    }
}
