package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.RoomLevel;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.TickEvent;
import org.junit.jupiter.api.Test;

/** Landings are felt the more the faster they are, and falls out of the level fade. */
class LandingDipTest {
    private record Landing(double deepest, double last, double bent) {}

    private static Landing fallFrom(double metres, PictureMotion motion) {
        HandWalk room =
                new HandWalk(RoomLevel.hall().startAt(0, metres, 0, 0, 0).level());
        room.walk().motion(motion);
        double deepest = 0;
        double dip = 0;
        double bent = 0;
        for (int tick = 0; tick < 300; tick++) {
            var walk = room.ticks(1).walk();
            // A frame is between the ticks before it.
            double eye = walk.view(1).eye().y();
            dip = walk.state().player().isGrounded()
                    ? walk.state().player().eye().y() - eye
                    : 0;
            deepest = Math.max(deepest, dip);
            bent = Math.max(bent, 1.8 - walk.frameState().character().heightMetres());
        }
        return new Landing(deepest, dip, bent);
    }

    @Test
    void theCameraDipsBySpeedAndComesBack() {
        Landing step = fallFrom(0.2, PictureMotion.FULL);
        Landing low = fallFrom(1, PictureMotion.FULL);
        Landing high = fallFrom(4, PictureMotion.FULL);
        assertEquals(0, step.deepest, 1e-9, "a step");
        assertTrue(low.deepest > 0.02 && low.deepest < 0.05, "from 1 m: " + low);
        assertTrue(high.deepest > 0.06 && high.deepest < 0.2, "from 4 m: " + high);
        assertEquals(0, high.last, 1e-3, "comes back");
        assertEquals(high.deepest, high.bent, 0.01, "the body sinks with the eye");
    }

    @Test
    void reducedMotionDoesWithout() {
        assertEquals(0, fallFrom(4, PictureMotion.REDUCED).deepest, 1e-9);
    }

    /** Black at once when the player is put back, and clear a quarter of a second later. */
    @Test
    void afterAFallThePictureComesBack() {
        for (PictureMotion motion : PictureMotion.values()) {
            HandWalk room =
                    new HandWalk(new RoomLevel().box(-1, -1, -1, 1, 0, 1).level());
            room.walk().motion(motion);
            assertEquals(0, room.ticks(60).walk().darkness(), "at the start");
            room.walk().takeCut();
            room.hold(PlayerInput.FORWARD);
            int ticks = 60;
            while (!room.ticks(1).walk().takeCut()) {
                assertEquals(0, room.walk().darkness());
                assertTrue(ticks++ < 2000, "fell");
            }
            room.hold(PlayerInput.NONE);
            assertEquals(motion == PictureMotion.FULL ? 1 : 0, room.walk().darkness());
            assertEquals(0, room.ticks(31).walk().darkness());
        }
    }

    /** With safe-return it is black by steps before the return, and clear by steps after it. */
    @Test
    void aFallFadesToItsReturn() {
        var settings = new SimSettings(120, List.of(Assist.SAFE_RETURN));
        for (PictureMotion motion : PictureMotion.values()) {
            HandWalk room =
                    new HandWalk(new RoomLevel().box(-1, -1, -1, 1, 0, 1).level(), settings);
            room.walk().motion(motion);
            room.ticks(60).hold(PlayerInput.FORWARD);
            double before = 0;
            boolean isBack = false;
            for (int ticks = 0; ticks < 400 && !isBack; ticks++) {
                isBack = room.ticks(1).walk().takeEvents().contains(TickEvent.Plain.PLAYER_RETURNED);
                double dark = room.walk().darkness();
                assertTrue(dark >= before && dark <= before + 1 / 30.0 + 1e-9, before + " then " + dark);
                before = dark;
            }
            assertTrue(isBack);
            assertEquals(motion == PictureMotion.FULL ? 1 : 0, before, "at the return");
            double after = room.hold(PlayerInput.NONE).ticks(15).walk().darkness();
            assertEquals(motion == PictureMotion.FULL ? 0.5 : 0, after, 1e-9, "half way");
            assertEquals(0, room.ticks(15).walk().darkness());
        }
    }
}
