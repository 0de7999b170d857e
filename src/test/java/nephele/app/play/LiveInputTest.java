package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Gamepad;
import nephele.app.window.Input;
import nephele.app.window.PadState;
import nephele.engine.level.Level;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.host.named.LevelName;
import nephele.host.playthrough.Playthrough;
import org.junit.jupiter.api.Test;

class LiveInputTest {
    private final Level level =
            new LevelName("levels/samples/walking.json").open().level();
    private final Input input = new Input();
    private GameSettings settings = GameSettings.DEFAULT;
    private final Playthrough playthrough = new Playthrough(
            level,
            new Playthrough.Beginning("walking.json", SimSettings.DEFAULT, null),
            new LiveInput(input, () -> settings));

    @Test
    void theRecordingOfHandsRepeatsTheGame() {
        input.key(Control.FORWARD, true);
        for (int tick = 0; tick < 200; tick++) {
            input.look(tick * 1.5, tick * 0.25);
            if (tick == 100) {
                input.key(Control.JUMP, true);
            }
            playthrough.tick();
        }
        var last = new SimState[1];
        playthrough.recorder().replay().play(new Simulation(level, SimSettings.DEFAULT), state -> last[0] = state);
        assertEquals(playthrough.state().hash(), last[0].hash());
        assertTrue(playthrough.state().player().feet().z() < 5, "walked");
    }

    /** Mouse counts turn the view without drift or jump: opposite turns end at the initial view angles. */
    @Test
    void turningThereAndBackEndsWhereItBegan() {
        var before = playthrough.state().player().heading();
        input.look(0, 0);
        for (int i = 1; i <= 1000; i++) {
            input.look(i * 7.25, 0);
            playthrough.tick();
        }
        for (int i = 999; i >= 0; i--) {
            input.look(i * 7.25, 0);
            playthrough.tick();
        }
        assertEquals(before, playthrough.state().player().heading());
    }

    @Test
    void motionBetweenTwoTicksBelongsToTheNextOne() {
        input.look(0, 0);
        input.look(10, 0);
        playthrough.advance(0);
        var before = playthrough.state().player().heading().yawRadians();
        playthrough.tick();
        assertEquals(
                -Math.toRadians(0.8), playthrough.state().player().heading().yawRadians() - before, 1e-9);
    }

    @Test
    void mouseSpeedAndInversionHoldAtOnce() {
        LiveInput hands = new LiveInput(input, () -> settings);
        input.look(0, 0);
        input.look(100, 50);
        var usual = hands.next();
        settings = settings.with(Settings.MOUSE_SPEED, 2.0).with(Settings.INVERT_MOUSE, Settings.Switch.ON);
        input.look(200, 100);
        var faster = hands.next();
        assertEquals(2 * usual.turnLeftMillidegrees(), faster.turnLeftMillidegrees());
        assertEquals(-2 * usual.turnUpMillidegrees(), faster.turnUpMillidegrees());
    }

    @Test
    void aToggledCrouchLastsUntilTheNextPress() {
        settings = settings.with(Settings.CROUCH, Settings.Crouch.TOGGLE);
        LiveInput hands = new LiveInput(input, () -> settings);
        boolean[] expected = {true, true, true, false, false};
        for (int i = 0; i < expected.length; i++) {
            input.key(Control.CROUCH, i == 0 || i == 1 || i == 3);
            assertEquals(expected[i], hands.next().holds(Action.CROUCH), "tick " + i);
        }
    }

    /** The walking speed is proportional to the stick; stick and keys together give at most full speed. */
    @Test
    void aStickWalksByDegrees() {
        var gamepad = new Gamepad(input);
        LiveInput hands = new LiveInput(input, () -> settings);
        gamepad.update(new PadState(Set.of(), 0, -0.59, 0, 0), Gamepad.Use.PLAY, 0.01);
        assertEquals(50, hands.next().forwardPercent());
        input.key(Control.FORWARD, true);
        assertEquals(100, hands.next().forwardPercent());
        input.key(Control.FORWARD, false);
        input.key(Control.BACK, true);
        assertEquals(-50, hands.next().forwardPercent());
    }
}
