package nephele.app.corpus;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import nephele.app.ChildJvm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Every level that {@code check} accepts is drawn, simulated and played, in ten seconds of CPU and 256 MiB of heap. */
@Execution(ExecutionMode.CONCURRENT)
class AcceptedLevelsTest {
    private static final Map<String, String> NO_DISPLAY = Map.of("DISPLAY", "", "WAYLAND_DISPLAY", "");

    private static final String REFUSED =
            """
            nothing.json: refused
            the-world-in-a-box.json: refused
            a-body-in-the-floor.json: refused
            a-body-in-the-player.json: refused
            bodies-in-each-other.json: refused
            a-model-larger-than-the-world.json: refused
            a-model-around-the-player.json: refused
            a-skybox-of-one-wide-picture.json: refused
            a-cross-that-is-none.json: refused
            """;

    @TempDir
    Path folder;

    @Test
    void whatCheckAcceptsIsShown() throws Exception {
        var run = ChildJvm.run(
                folder,
                NO_DISPLAY,
                "-Xmx256m",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                CorpusRun.class.getName());
        assertEquals(REFUSED, run.out());
        assertEquals(0, run.exitCode(), run.err());
        assertTrue(Files.exists(folder.resolve("shown/picture.png")), "something was accepted");
    }
}
