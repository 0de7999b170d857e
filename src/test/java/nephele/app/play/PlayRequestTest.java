package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.engine.draw.QualityChoice;
import nephele.engine.named.LevelName;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.userfile.UserFolders;
import org.junit.jupiter.api.Test;

/** Options of the command line go before the player's settings, which hold where no option is given. */
class PlayRequestTest {
    private final PlayerFiles files = new PlayerFiles(new UserFolders(null, null));

    private PlayRequest request(QualityChoice quality, PlayRequest.Shown shown, SimSettings simulation) {
        var player = new PlayRequest.Player(files, null);
        return new PlayRequest(new LevelName("a.json"), null, quality, shown, null, simulation, null, null, player);
    }

    @Test
    void theSettingsHoldWithoutOptions() {
        var request = request(null, null, null);
        assertEquals("auto", request.chosenQuality().preset());
        assertEquals(
                List.of(Assist.FUNNEL, Assist.FLOOR_EXIT_SPEED),
                request.settings().assists());
        files.keep(files.settings()
                .with(Settings.QUALITY, Settings.QualityPreset.LOW)
                .with(Settings.REDUCED_MOTION, Settings.Switch.ON));
        assertEquals("low", request.chosenQuality().preset());
        assertEquals(
                SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND,
                request.settings().uprightDegreesPerSecond());
    }

    @Test
    void optionsGoFirst() {
        var request = request(new QualityChoice("ultra", Map.of()), null, SimSettings.DEFAULT);
        assertEquals("ultra", request.chosenQuality().preset());
        assertEquals(SimSettings.DEFAULT, request.settings());
        assertEquals(
                "ultra", request.of(new LevelName("b.json")).chosenQuality().preset());
    }

    @Test
    void onlyWhatIsPlayedCounts() {
        var replay = new Replay("a.json", SimSettings.DEFAULT, null, List.of());
        assertTrue(request(null, null, null).isPlayed());
        var shown = request(null, new PlayRequest.Shown(replay, PlayRequest.Shown.NEVER), null);
        assertFalse(shown.isPlayed());
        assertNull(shown.of(new LevelName("b.json")).replay());
        assertTrue(request(null, new PlayRequest.Shown(replay, 0), null).isPlayed());
    }

    /** 90° at 16:9 are 58.7° vertically. */
    @Test
    void theFieldOfViewIsThatOfAWideScreen() {
        assertEquals(58.716, ChosenSettings.verticalFovDegrees(files.settings()), 1e-3);
    }
}
