package nephele.editor.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.VirtualDisplay;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The canvas on a display of its own. */
class AwtGlSurfaceSwingTest {
    @TempDir
    Path folder;

    private ChildJvm run(VirtualDisplay display) throws Exception {
        try (display) {
            Map<String, String> environment = Map.of("DISPLAY", display.name(), "WAYLAND_DISPLAY", "");
            return ChildJvm.run(folder, environment, CanvasScenarios.class.getName());
        }
    }

    private static void assertFine(ChildJvm run) {
        List<String> lines = run.out().lines().toList();
        assertEquals(8, lines.size(), run.out() + run.err());
        lines.subList(0, 7).forEach(line -> assertTrue(line.endsWith(": ok"), run.out() + run.err()));
    }

    @Test
    void theCanvasShowsPicturesAndLeavesNothingBehind() throws Exception {
        ChildJvm run = run(VirtualDisplay.start());
        assertFine(run);
        assertTrue(run.out().endsWith("canvas\n"), run.out());
    }

    @Test
    void withoutGlxThePictureIsDrawnOffscreen() throws Exception {
        ChildJvm run = run(VirtualDisplay.startWithoutOpenGl());
        assertFine(run);
        assertTrue(run.out().contains("the viewport is drawn offscreen: "), run.out());
    }
}
