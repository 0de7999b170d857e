package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.scene.FrameState;
import nephele.engine.sim.replay.Replay;
import nephele.host.named.LevelName;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The frame state of the crate that the recorded walk carries through a portal. */
class HeldInPlayTest {
    private static final LevelName LEVEL = new LevelName("levels/04-cube.json");

    private final Replay replay = LEVEL.recordedWalk();
    private final Playthrough walk = new Playthrough(
            LEVEL.open().level(),
            new Playthrough.Beginning(LEVEL.fileName(), replay.settings(), replay.start()),
            new ReplayInput(replay));

    private void pickUp() {
        while (!walk.state().world().holding().isHolding()) {
            assertEquals(FrameState.NOTHING, walk.frameState().held());
            walk.tick();
        }
    }

    private void tick(int times) {
        for (int i = 0; i < times; i++) {
            walk.tick();
        }
    }

    /** The held crate becomes transparent and stays so through the portal, straight ahead and at the same distance. */
    @Test
    void itBecomesClearAndStaysThroughThePortal() {
        pickUp();
        assertTrue(
                walk.frameState().heldClarity() < 0.1,
                "clear at once: " + walk.frameState().heldClarity());
        tick(60);
        boolean crossed = false;
        for (int i = 0; i < 600; i++) {
            walk.tick();
            FrameState frameState = walk.frameState();
            assertEquals(0, frameState.held());
            assertEquals(1, frameState.heldClarity());
            Vector3d ahead = frameState.heldFromEye().toVector();
            assertTrue(
                    ahead.length() > 0.5 && ahead.length() < 2,
                    "tick " + walk.state().tick() + ": " + ahead);
            assertTrue(-ahead.z > 0.8 * ahead.length(), "tick " + walk.state().tick() + ": " + ahead);
            crossed |= walk.state().world().trace().playerCrossed().length() > 0;
        }
        assertTrue(crossed);
    }

    @Test
    void inTheThirdPersonItIsSolid() {
        pickUp();
        tick(60);
        walk.changePerson();
        tick(1);
        double first = walk.frameState().heldClarity();
        assertTrue(first > 0.9 && first < 1, "fades: " + first);
        tick(60);
        assertEquals(FrameState.NOTHING, walk.frameState().held());
    }
}
