package nephele.app.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.Main;
import nephele.app.VirtualDisplay;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The viewer works in a real window, and without a display. */
@Execution(ExecutionMode.SAME_THREAD)
class SceneViewerSwingTest {
    @TempDir
    Path folder;

    @Test
    void theViewerSurvivesWhatHappensToItsWindow() throws Exception {
        try (var display = VirtualDisplay.start()) {
            var run = ChildJvm.run(
                    folder,
                    Map.of("DISPLAY", display.name(), "WAYLAND_DISPLAY", ""),
                    "-Duser.home=" + folder,
                    ViewerScenarios.class.getName(),
                    scene("solar-system"),
                    scene("ship"));
            var wrong = run.out().lines().filter(line -> !line.endsWith(": ok")).toList();
            assertEquals(List.of(), wrong, run.err());
            assertEquals(16, run.out().lines().count(), run.out() + run.err());
            assertEquals(0, run.exitCode());
        }
    }

    @Test
    void withoutADisplayThreePicturesAreSaved() throws Exception {
        var run = ChildJvm.run(
                folder,
                Map.of("DISPLAY", "", "WAYLAND_DISPLAY", ""),
                Main.class.getName(),
                "scene",
                scene("primitives/torus"),
                "--size",
                "160x120");
        assertEquals(0, run.exitCode(), run.err());
        assertTrue(run.err().lines().allMatch(line -> line.contains(": at work for ")), run.err());
        for (int i = 1; i <= 3; i++) {
            var picture = folder.resolve("build/pictures/torus-" + i + ".png");
            assertTrue(Files.size(picture) > 1000, picture + " of " + run.out());
        }
    }

    private static String scene(String name) {
        return Path.of("scenes", name + ".xml").toAbsolutePath().toString();
    }
}
