package nephele.engine.render.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.VirtualDisplay;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The context that Windows and macOS draw offscreen with, on a display of Linux. */
class HiddenWindowGlTest {
    @TempDir
    Path folder;

    @Test
    void aFrameIsTheSameInAHiddenWindow() throws Exception {
        try (VirtualDisplay display = VirtualDisplay.start()) {
            Map<String, String> environment = Map.of("DISPLAY", display.name(), "WAYLAND_DISPLAY", "");
            ChildJvm run = ChildJvm.run(folder, environment, FrameOfHiddenWindow.class.getName());
            String expected = Arrays.hashCode(AdoptedContextGlTest.expected()) + "\n";
            assertEquals(expected, run.out(), run.err());
        }
    }

    /** A process that draws the frame. */
    static final class FrameOfHiddenWindow {
        private FrameOfHiddenWindow() {}

        public static void main(String[] words) {
            try (GlContext gl = GlContext.ofHiddenWindow()) {
                System.out.println(Arrays.hashCode(AdoptedContextGlTest.frame(gl)));
            }
        }
    }
}
