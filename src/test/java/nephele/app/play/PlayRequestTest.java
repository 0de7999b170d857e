package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.named.LevelName;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.Test;

class PlayRequestTest {
    private static final SimSettings DEFAULTS = SimSettings.DEFAULT;

    /** A replay keeps its own settings, however often it is restarted. */
    @Test
    void aRestartTakesChangedSettingsOnlyWherePlayersPlay() {
        var byHand = request(null);
        assertEquals("from the next start or restart on", byHand.settingsHold());
        var replayed = request(new Replay("a.json", DEFAULTS, null, List.of()));
        assertEquals("from the next start on; a replay keeps its own", replayed.settingsHold());
        assertEquals(byHand.settingsHold(), replayed.of(new LevelName("b.json")).settingsHold());
    }

    private static PlayRequest request(Replay replay) {
        return new PlayRequest(new LevelName("a.json"), null, null, replay, null, DEFAULTS, null);
    }
}
