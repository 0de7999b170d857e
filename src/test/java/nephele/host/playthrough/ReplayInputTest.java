package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.Test;

class ReplayInputTest {
    @Test
    void everyTickComesOnceAndThenNothing() {
        var jump = PlayerInput.FORWARD.holding(Action.JUMP);
        var replay = new ReplayRecorder("a.json", SimSettings.DEFAULT, null)
                .record(PlayerInput.FORWARD, 3)
                .record(jump)
                .record(PlayerInput.NONE, 2)
                .replay();
        var input = new ReplayInput(replay);
        for (var expected : new PlayerInput[] {
            PlayerInput.FORWARD, PlayerInput.FORWARD, PlayerInput.FORWARD, jump, PlayerInput.NONE, PlayerInput.NONE
        }) {
            assertFalse(input.isFinished());
            assertEquals(expected, input.next());
        }
        assertTrue(input.isFinished());
        assertEquals(PlayerInput.NONE, input.next());
    }
}
