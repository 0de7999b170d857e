package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.LevelJsonTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Every kind of bad input ends, within 256 MiB, in a line that names file and JSON path. */
@Execution(ExecutionMode.CONCURRENT)
class BadLevelsTest {
    @TempDir
    Path folder;

    @Test
    void thereAreAtLeastSixtyKinds() {
        List<BadLevel> kinds = BadLevelRun.all();
        assertTrue(kinds.size() >= 60, "only " + kinds.size());
        assertEquals(kinds.size(), kinds.stream().distinct().count());
    }

    /** Judges all kinds one after another in a process with 256 MiB, which prints each wrong answer. */
    @Test
    void eachIsRefusedNamingFileAndPathInAQuarterOfAGibibyte() throws Exception {
        BadLevelRun.prepare(folder);
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx256m",
                        "-XX:+UseSerialGC",
                        "-XX:TieredStopAtLevel=1",
                        "-Djava.awt.headless=true",
                        "-cp",
                        System.getProperty("java.class.path"),
                        BadLevelRun.class.getName(),
                        folder.toString())
                .redirectErrorStream(true)
                .start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals("", output);
        assertEquals(0, process.waitFor());
    }

    @Test
    void everyTruncationOfALevelIsRefused() {
        byte[] whole = LevelJsonTest.PUFF.strip().getBytes(StandardCharsets.UTF_8);
        for (int length = 0; length < whole.length; length++) {
            List<Problem> problems =
                    LevelJsonTest.problems(new String(Arrays.copyOf(whole, length), StandardCharsets.UTF_8));
            assertTrue(problems.get(0).isError());
        }
    }

    /** A flipped bit gives another level or a refusal; no other exception escapes. */
    @Test
    void everyFlippedBitIsReadOrRefused() {
        byte[] whole = LevelJsonTest.PUFF.getBytes(StandardCharsets.UTF_8);
        for (int bit = 0; bit < whole.length * 8; bit++) {
            byte[] flipped = whole.clone();
            flipped[bit / 8] ^= (byte) (1 << bit % 8);
            try {
                LevelJson.read("flipped", flipped);
            } catch (LevelFormatException refused) {
                assertTrue(refused.getMessage().startsWith("flipped: "));
            }
        }
    }
}
