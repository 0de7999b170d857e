package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.QualityMemory;
import nephele.engine.render.frame.Quality;
import nephele.host.draw.QualityChoice;
import nephele.host.draw.QualityFront;
import nephele.host.named.LevelName;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The quality of a level's first frame: measured on a new machine, learned on one that drew the level before. */
class AutoQualityTest {
    private static final long PIXELS = 1280 * 720;

    @TempDir
    Path folder;

    private final ByteArrayOutputStream log = new ByteArrayOutputStream();

    private AutoQuality auto() {
        return new AutoQuality(files(), "llvmpipe", true, new PrintStream(log, true, StandardCharsets.UTF_8));
    }

    private PlayerFiles files() {
        return new PlayerFiles(new UserFolders(folder.resolve("c"), folder.resolve("s"), null));
    }

    private PlayRequest request(String quality) {
        return request(quality, "levels/01-courtyard.json");
    }

    private PlayRequest request(String quality, String level) {
        var picture = new PlayRequest.Picture(1280, 720, false);
        return new PlayRequest(
                new LevelName(level),
                null,
                new QualityChoice(quality, Map.of()),
                null,
                null,
                null,
                null,
                picture,
                new PlayRequest.Player(files(), null));
    }

    /** Plays frames that cost 60 ms at quality high. */
    /** What a frame costs at quality high: then {@code low} is within 30 frames a second, and no better point is. */
    private static final double HIGH_MILLIS = 100;

    private static int changes(AutoQuality auto, PlayRequest request) {
        int changes = 0;
        for (int frame = 0; frame < 300; frame++) {
            Quality quality = auto.of(request).orElseThrow();
            double cost = QualityFront.SOFTWARE.points().stream()
                    .filter(point -> point.quality().equals(quality))
                    .findFirst()
                    .orElseThrow()
                    .cost();
            changes += auto.frame(request, HIGH_MILLIS * cost, PIXELS) ? 1 : 0;
        }
        return changes;
    }

    @Test
    void aNewMachineIsMeasuredAndOneSeenBeforeIsKnown() {
        var request = request("auto");
        var first = auto();
        first.levelBegins(request, PIXELS);
        assertTrue(first.wantsMeasurement(request));
        first.firstViewCosts(request, 22);
        assertFalse(first.wantsMeasurement(request), "once");
        Optional<Quality> chosen = first.of(request);
        var killed = auto();
        killed.levelBegins(request, PIXELS);
        assertFalse(killed.wantsMeasurement(request), "the measurement is kept at once");
        assertEquals(chosen, killed.of(request));
        assertTrue(changes(first, request) <= 1);
        first.levelEnds();

        var second = auto();
        second.levelBegins(request, PIXELS);
        assertFalse(second.wantsMeasurement(request));
        assertEquals(Optional.of(Quality.LOW), second.of(request));
        assertEquals(0, changes(second, request));
        assertTrue(log.toString(StandardCharsets.UTF_8).contains(", learned, 0.0 s after 01-courtyard.json"));
    }

    @Test
    void aQualityThatThePlayerChoseIsNeverMeasured() {
        var request = request("medium");
        var auto = auto();
        auto.levelBegins(request, PIXELS);
        assertFalse(auto.wantsMeasurement(request));
        assertEquals(Optional.empty(), auto.of(request));
        assertEquals(List.of(Quality.HIGH), auto.ofTitle(request).stream().toList(), "but the title is sharp");
        assertEquals("", log.toString(StandardCharsets.UTF_8));
    }

    @Test
    void aLevelOfTheSameNameInAnotherFolderIsMeasuredItself() {
        var first = auto();
        first.levelBegins(request("auto"), PIXELS);
        first.firstViewCosts(request("auto"), 22);
        var own = request("auto", folder.resolve("01-courtyard.json").toString());
        var second = auto();
        second.levelBegins(own, PIXELS);
        assertTrue(second.wantsMeasurement(own));
    }

    /** What was learned at one size of the window is not mixed with the frames of another one. */
    @Test
    void anotherSizeOfTheWindowIsLearnedApart() {
        var request = request("auto");
        var auto = auto();
        auto.levelBegins(request, PIXELS);
        changes(auto, request);
        auto.frame(request, 5, PIXELS / 4);
        double learned = files().quality()
                .highMillis(QualityMemory.machine("llvmpipe"), "01-courtyard.json", PIXELS)
                .orElseThrow();
        assertEquals(HIGH_MILLIS, learned, 20);
    }
}
