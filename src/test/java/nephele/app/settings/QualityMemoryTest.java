package nephele.app.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What was learned of quality survives a restart; a broken file or entry only makes it be learned again. */
class QualityMemoryTest {
    private static final String MACHINE = "AMD EPYC × 2, llvmpipe";
    private static final String LEVEL = "01-courtyard.json";

    @TempDir
    Path folder;

    private PlayerFiles files() {
        return new PlayerFiles(new UserFolders(folder.resolve("c"), folder.resolve("s"), null));
    }

    @Test
    void whatIsLearnedIsKnownAfterARestartAtEverySize() {
        var first = files();
        first.keep(first.quality().with(MACHINE, LEVEL, 921_600, 120));
        var known = files().quality();
        assertEquals(120, known.highMillis(MACHINE, LEVEL, 921_600).orElseThrow(), 0.01);
        assertEquals(30, known.highMillis(MACHINE, LEVEL, 230_400).orElseThrow(), 0.01);
        assertTrue(known.highMillis("another machine", LEVEL, 1).isEmpty());
        assertTrue(known.highMillis(MACHINE, "02-first-shot.json", 1).isEmpty());
    }

    @Test
    void aBrokenFileIsSilentAndLearnedAgain() throws IOException {
        for (String broken : List.of("", "[]", "{\"format\": \"nephele-quality\", \"version\": 2}", "\0")) {
            Files.createDirectories(folder.resolve("s"));
            Files.writeString(folder.resolve("s/quality.json"), broken);
            var files = files();
            assertEquals(List.of(), files.takeProblems(), broken);
            files.keep(files.quality().with(MACHINE, LEVEL, 100, 50));
            assertEquals(50, files().quality().highMillis(MACHINE, LEVEL, 100).orElseThrow(), 0.01);
        }
    }

    @Test
    void aBrokenEntryIsUnknownAndReplaced() {
        for (String broken : List.of(
                "{\"machines\": 3}",
                "{\"machines\": {\"" + MACHINE + "\": []}}",
                "{\"machines\": {\"" + MACHINE + "\": {\"" + LEVEL + "\": null}}}",
                "{\"machines\": {\"" + MACHINE + "\": {\"" + LEVEL + "\": {\"highNanosPerPixel\": -1}}}}",
                "{\"machines\": {\"" + MACHINE + "\": {\"" + LEVEL + "\": {\"highNanosPerPixel\": \"NaN\"}}}}",
                "{\"machines\": {\"" + MACHINE + "\": {\"" + LEVEL + "\": {\"highNanosPerPixel\": 1e999}}}}")) {
            var memory = new QualityMemory(JsonParser.parseString(broken).getAsJsonObject());
            assertTrue(memory.highMillis(MACHINE, LEVEL, 1).isEmpty(), broken);
            var learned = memory.with(MACHINE, LEVEL, 100, 50);
            assertEquals(50, learned.highMillis(MACHINE, LEVEL, 100).orElseThrow(), 0.01);
        }
    }

    @Test
    void theOldestOfTooManyAreForgotten() {
        var memory = new QualityMemory(new JsonObject());
        for (int level = 0; level <= 200; level++) {
            memory = memory.with(MACHINE, "level" + level, 100, 50);
        }
        assertTrue(memory.highMillis(MACHINE, "level0", 1).isEmpty());
        assertTrue(memory.highMillis(MACHINE, "level1", 1).isPresent());
        assertTrue(memory.highMillis(MACHINE, "level200", 1).isPresent());
    }
}
