package nephele.app.corpus;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import nephele.app.ChildJvm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whatever {@code check} accepts is drawn, simulated and played, in ten seconds of CPU and 256 MiB of heap. */
class AcceptedLevelsGlTest {
    private static final Map<String, String> NO_DISPLAY = Map.of("DISPLAY", "", "WAYLAND_DISPLAY", "");

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
        assertEquals("", run.out());
        assertEquals(0, run.exitCode(), run.err());
        assertTrue(Files.exists(folder.resolve("shown/picture.png")), "something was accepted");
    }
}
