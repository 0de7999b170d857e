package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;

/** Options of the command line go before the player's settings, which hold where no option is given. */
class PlayRequestTest {
    private final PlayerFiles files = new PlayerFiles(new UserFolders(null, null, null));

    private PlayRequest request(QualityChoice quality, PlayRequest.Shown shown, SimSettings simulation) {
        var player = new PlayRequest.Player(files, null);
        return new PlayRequest(new LevelName("a.json"), null, quality, shown, null, simulation, null, null, player);
    }

    @Test
    void theSettingsHoldWithoutOptions() {
        var request = request(null, null, null);
        assertEquals("auto", request.chosenQuality().preset());
        assertEquals(Assist.USUAL, request.settings().assists());
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

    /** One rule: by hand, from the level's start, with the simulation of the player's settings. */
    @Test
    void onlyWhatIsPlayedByHandFromTheStartIsRanked() {
        var replay = new Replay("a.json", SimSettings.DEFAULT, null, List.of());
        var usual = files.settings().simulation();
        assertTrue(request(null, null, null).isRanked());
        assertTrue(request(new QualityChoice("low", Map.of("samples", "2")), null, null)
                .isRanked());
        assertTrue(request(null, null, usual).isRanked());
        assertFalse(request(null, new PlayRequest.Shown(replay, PlayRequest.Shown.NEVER), null)
                .isRanked());
        for (long tick : new long[] {0, 1, 1660}) {
            assertFalse(request(null, new PlayRequest.Shown(replay, tick), null).isRanked(), "taken over at " + tick);
        }
        var elsewhere = request(null, null, null).from(new PlayerStart(Vec3.ZERO, 0, 0));
        assertFalse(elsewhere.isRanked());
        assertFalse(request(null, null, usual.withTicksPerSecond(240)).isRanked());
        assertFalse(request(null, null, new SimSettings(120, List.of())).isRanked());
        assertFalse(request(null, null, new SimSettings(120, List.of(Assist.values())))
                .isRanked());
        assertTrue(elsewhere.of(new LevelName("b.json")).isRanked(), "the next level begins at its start");
        files.keep(files.settings().with(Settings.ASSISTS, Settings.Assists.NONE));
        assertTrue(request(null, null, null).isRanked(), "the player's own settings");
    }

    /** 90° at 16:9 are 58.7° vertically. */
    @Test
    void theFieldOfViewIsThatOfAWideScreen() {
        assertEquals(58.716, files.settings().verticalFovDegrees(), 1e-3);
    }
}
