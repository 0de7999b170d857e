package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.app.levels.LevelName;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerInput;
import nephele.engine.sim.SimSettings;
import nephele.engine.sim.SimState;
import nephele.engine.sim.Simulation;
import org.junit.jupiter.api.Test;

class WalkTest {
    /** Two ticks and a half, rounded up. */
    private static final long FRAME_NANOS = 20_833_334;

    private final Level level =
            new LevelName("levels/samples/walking.json").open().level();
    private final Input input = new Input();
    private final Walk walk =
            new Walk(level, new Walk.Beginning("walking.json", SimSettings.DEFAULT, null), new LiveInput(input));

    @Test
    void framesOfAnyLengthMakeTheTicksThatAreDue() {
        for (int frame = 0; frame < 100; frame++) {
            walk.advance(FRAME_NANOS);
        }
        assertEquals(250, walk.state().tick());
    }

    @Test
    void theRecordingOfHandsRepeatsTheGame() {
        input.key(Control.FORWARD, true);
        for (int tick = 0; tick < 200; tick++) {
            input.look(tick * 1.5, tick * 0.25);
            if (tick == 100) {
                input.key(Control.JUMP, true);
            }
            walk.tick();
        }
        var last = new SimState[1];
        walk.recorder().replay().play(new Simulation(level, SimSettings.DEFAULT), state -> last[0] = state);
        assertEquals(walk.state().hash(), last[0].hash());
        assertTrue(walk.state().player().feet().z() < 5, "walked");
    }

    /** C.2 row 8, from the window's counts to the view: no drift, no jump, whatever the mouse says. */
    @Test
    void turningThereAndBackEndsWhereItBegan() {
        var before = walk.state().player().heading();
        input.look(0, 0);
        for (int i = 1; i <= 1000; i++) {
            input.look(i * 7.25, 0);
            walk.tick();
        }
        for (int i = 999; i >= 0; i--) {
            input.look(i * 7.25, 0);
            walk.tick();
        }
        assertEquals(before, walk.state().player().heading());
    }

    /** Whoever falls out of the level begins again: the picture before has nothing to do with it. */
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

    /** Straight on through a portal is no cut. */
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

    @Test
    void motionBetweenTwoTicksBelongsToTheNextOne() {
        input.look(0, 0);
        input.look(10, 0);
        walk.advance(0);
        var before = walk.state().player().heading().yawRadians();
        walk.tick();
        assertEquals(-Math.toRadians(0.8), walk.state().player().heading().yawRadians() - before, 1e-9);
    }
}
