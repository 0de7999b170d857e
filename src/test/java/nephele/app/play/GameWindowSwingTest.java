package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.Main;
import nephele.app.VirtualDisplay;
import nephele.engine.sim.replay.Replay;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The window works on a display of its own: Xvfb is started here, whatever display the machine has. */
@Execution(ExecutionMode.SAME_THREAD)
class GameWindowSwingTest {
    private static final String LOADED_CLASSES = "-Xlog:class+load:file=loaded.txt";

    private static VirtualDisplay display;

    @TempDir
    Path folder;

    @BeforeAll
    static void startXvfb() throws IOException {
        display = VirtualDisplay.start();
    }

    @AfterAll
    static void stopXvfb() {
        if (display != null) {
            display.close();
        }
    }

    @Test
    void theGameSurvivesWhatHappensToItsWindow() throws Exception {
        var level = Path.of("levels", "samples", "walking.json").toAbsolutePath();
        var run = ChildJvm.run(
                folder,
                Map.of("DISPLAY", display.name(), "WAYLAND_DISPLAY", ""),
                "-Duser.home=" + folder,
                LOADED_CLASSES,
                WindowScenarios.class.getName(),
                level.toString());
        var wrong = run.out().lines().filter(line -> !line.endsWith(": ok")).toList();
        assertEquals(List.of(), wrong, run.err());
        assertEquals(35, run.out().lines().count(), run.out() + run.err());
        assertEquals(0, run.exitCode());
        assertTrue(recordedTicks("walk.json") > 0);
        assertTrue(recordedTicks("walk-2.json") >= 0);
        assertOnlyTheGame("nephele.host.playthrough.Playthrough ");
    }

    private void assertOnlyTheGame(String loadedClass) throws IOException {
        var loaded = Files.readString(folder.resolve("loaded.txt"));
        assertTrue(loaded.contains(loadedClass), loadedClass);
        assertEquals(
                List.of(),
                loaded.lines()
                        .filter(line -> line.contains("nephele.lab.") || line.contains("nephele.scenes."))
                        .toList());
    }

    /** Returns the length of a recorded walk; there is one before the restart and one after it. */
    private long recordedTicks(String name) throws IOException {
        return Replay.read(name, Files.readAllBytes(folder.resolve(name))).ticks();
    }

    @Test
    void anOldOpenGlIsExplained() throws Exception {
        var old = Map.of(
                "DISPLAY", display.name(),
                "WAYLAND_DISPLAY", "",
                "MESA_GL_VERSION_OVERRIDE", "3.2",
                "MESA_GLSL_VERSION_OVERRIDE", "150");
        var run = ChildJvm.run(folder, old, LOADED_CLASSES, Main.class.getName(), "play", sample());
        assertEquals(3, run.exitCode(), run.err());
        assertTrue(run.err().contains("4.1"), run.err());
        assertFalse(run.err().contains("\tat "), run.err());
        assertOnlyTheGame("nephele.app.command.PlayCommand ");
    }

    private static String sample() {
        return Path.of("levels", "samples", "walking.json").toAbsolutePath().toString();
    }
}
