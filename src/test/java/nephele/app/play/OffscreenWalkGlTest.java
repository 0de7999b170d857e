package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.settings.PlayerFiles;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OffscreenWalkGlTest {
    @TempDir
    Path folder;

    private PlayRequest request(Path record) {
        return new PlayRequest(
                new LevelName("levels/samples/walking.json"),
                null,
                new QualityChoice("low", Map.of()),
                new PlayRequest.Shown(Replay.standing("walking.json", 240), PlayRequest.Shown.NEVER),
                record,
                SimSettings.DEFAULT,
                null,
                new PlayRequest.Picture(64, 36, false),
                new PlayRequest.Player(new PlayerFiles(new UserFolders(null, null, null)), null));
    }

    private String run(PlayRequest request) throws Exception {
        var out = new ByteArrayOutputStream();
        new OffscreenWalk(request, new PrintStream(out, true, StandardCharsets.UTF_8), folder).run();
        return out.toString(StandardCharsets.UTF_8);
    }

    @Test
    void aWalkLeavesThreePicturesAndFigures() throws Exception {
        var text = run(request(null));
        try (var files = Files.list(folder)) {
            assertEquals(
                    List.of("walking-1.png", "walking-2.png", "walking-3.png"),
                    files.map(file -> file.getFileName().toString()).sorted().toList());
        }
        assertTrue(
                text.matches("(?s).*frames \\d+, CPU [\\d.]+ ms a frame, wall p50 [\\d.]+ ms, p95 [\\d.]+ ms,"
                        + " draws [\\d.]+, triangles \\d+\n"),
                text);
    }

    @Test
    void aRecordingOfAReplayIsTheReplay() throws Exception {
        var record = folder.resolve("again.json");
        run(request(record));
        var again = Replay.read("again.json", Files.readAllBytes(record));
        assertEquals(240, again.ticks());
        assertEquals(Replay.standing("walking.json", 240).inputs(), again.inputs());
    }
}
