package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState.Posture;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The character between two ticks does not jump when its middle goes through a portal before its body does. */
class FrameInterpolationTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static Portal portal(String id, String linkedTo, Vec3 centre, Vec3 normal) {
        return Portal.of(
                new PortalSpec(id, linkedTo, centre, normal, new Vec3(0.3, 0.2, -1), 3, 3, PortalShape.RECTANGLE));
    }

    /** Over a floor portal that leads to a wall, the character sinks with its eye, also crouching, for any yaw. */
    @Test
    void theCharacterSinksThroughAFloorWithoutAJump() {
        Portals portals = new Portals(
                List.of(
                        portal("floor", "wall", Vec3.ZERO, UP),
                        portal("wall", "floor", new Vec3(40, 3, 5), new Vec3(1, 0.2, 0.4))),
                List.of(1, 0));
        var live = new FrameInterpolation(RoomLevel.hall().level());
        live.frameState().portals(portals);
        for (double height : new double[] {1.8, 1.1}) {
            for (double yaw = -3; yaw < 3; yaw += 0.7) {
                int beyond = 0;
                for (double middle = 0.2; middle > -0.2; middle -= 0.01) {
                    Posture posture = posture(live, middle, height, yaw);
                    if (posture.centre().x() > 20) {
                        beyond++;
                        posture = posture.through(portals.transform(1));
                    }
                    String where = "at " + middle + ", height " + height;
                    assertEquals(middle, posture.centre().y(), 1e-9, where);
                    assertEquals(0.1, posture.centre().x(), 1e-9, where);
                    assertEquals(1, posture.up().y(), 1e-9, where);
                    assertEquals(yaw, posture.yawRadians(), 1e-6, where);
                }
                assertTrue(beyond >= 19, "beyond the portal: " + beyond);
            }
        }
    }

    /** A body that returns to the world is at its place in every frame of the tick, and nowhere on the way. */
    @Test
    void aReturningBodyIsNotSeenOnTheWay() {
        Vec3 home = new Vec3(5, 1, 0);
        Level level =
                new RoomLevel().box(-2, -1, -2, 2, 0, 2).cube(home, 0.5, 10).level();
        var simulation = new Simulation(level, new SimSettings(120, List.of(Assist.BODY_RETURN)));
        var live = new FrameInterpolation(level);
        SimState before = simulation.start();
        SimState after = simulation.step(before, PlayerInput.NONE);
        while (after.world().trace().events().isEmpty()) {
            before = after;
            after = simulation.step(before, PlayerInput.NONE);
        }
        assertEquals(
                List.of(new TickEvent.BodyReturned(0)), after.world().trace().events());
        for (double share : new double[] {0, 0.3, 0.9}) {
            live.world(before, after, share, null);
            assertEquals(home, Vec3.of(live.frameState().centre(0, new Vector3d())), "share " + share);
        }
    }

    private static Posture posture(FrameInterpolation live, double middle, double height, double yaw) {
        Vec3 centre = new Vec3(0.1, 0.3, -0.2);
        Vec3 eye = new Vec3(0.1, middle + height / 2 - 0.15, -0.2);
        var pose = new PlayerPose(eye, null, new PlayerPose.Body(centre, eye, UP, yaw, 0.1), null);
        live.character(pose, new AnimationState(height, 0, 0, 0, 0, 0), 0, 0);
        return live.frameState().character();
    }
}
