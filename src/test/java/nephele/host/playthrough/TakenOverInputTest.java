package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The replay plays up to the tick, and the player from it on, also after the replay's last tick. */
class TakenOverInputTest {
    private static final PlayerInput LIVE = PlayerInput.NONE.walking(0, 77);

    private static Replay replay() {
        var recorder = new ReplayRecorder("a.json", SimSettings.DEFAULT, null);
        for (int i = 0; i < 5; i++) {
            recorder.record(PlayerInput.NONE.walking(i, 0));
        }
        return recorder.replay();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3, 5})
    void thePlayerFollowsTheReplay(int tick) {
        List<Integer> takenAt = new ArrayList<>();
        List<PlayerInput> inputs = new ArrayList<>();
        TickInput live = new TickInput() {
            @Override
            public PlayerInput next() {
                return LIVE;
            }

            @Override
            public boolean isFinished() {
                return false;
            }
        };
        var input = new TakenOverInput(replay(), tick, live, () -> takenAt.add(inputs.size()));
        for (int i = 0; i < 8; i++) {
            assertFalse(input.isFinished());
            inputs.add(input.next());
            assertEquals(i < tick ? PlayerInput.NONE.walking(i, 0) : LIVE, inputs.get(i));
        }
        assertEquals(List.of(tick), takenAt);
    }
}
