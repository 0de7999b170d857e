package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import org.junit.jupiter.api.Test;

class PlaythroughTest {
    /** Length of two and a half ticks, rounded up. */
    private static final long FRAME_NANOS = 20_833_334;

    @Test
    void framesOfAnyLengthMakeTheTicksThatAreDue() {
        Playthrough walk = new HandWalk(RoomLevel.hall().level()).walk();
        for (int frame = 0; frame < 100; frame++) {
            walk.advance(FRAME_NANOS);
        }
        assertEquals(250, walk.state().tick());
    }

    /** A player that falls out of the level is reset: the view is discontinuous. */
    @Test
    void aBeginningAndALeapAreCuts() {
        HandWalk room = new HandWalk(new RoomLevel().box(-1, -1, -1, 1, 0, 1).level());
        assertTrue(room.walk().takeCut(), "the first picture");
        assertFalse(room.ticks(60).walk().takeCut());
        room.hold(PlayerInput.FORWARD);
        int cuts = 0;
        for (int tick = 0; tick < 700; tick++) {
            double before = room.walk().state().player().feet().y();
            boolean leaps = room.ticks(1).walk().state().player().feet().y() > before + 10;
            assertEquals(leaps, room.walk().takeCut());
            cuts += leaps ? 1 : 0;
        }
        assertTrue(cuts >= 1, "fell");
    }

    /** A walk straight on through a portal is continuous. */
    @Test
    void aCrossingIsNoCut() {
        HandWalk room = new HandWalk(RoomLevel.hall()
                .pair(new Vec3(0, 1.05, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.05, 0), new Vec3(1, 0, 0))
                .startAt(0, 0, -6, 0, 0)
                .level());
        assertTrue(room.walk().takeCut());
        room.hold(PlayerInput.FORWARD).ticks(120);
        assertTrue(room.walk().state().player().feet().x() < -5, "crossed");
        assertFalse(room.walk().takeCut());
    }
}
