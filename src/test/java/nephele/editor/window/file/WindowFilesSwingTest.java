package nephele.editor.window.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.VirtualDisplay;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The dialogues about files in a real window, answered with the mouse. */
@Execution(ExecutionMode.SAME_THREAD)
class WindowFilesSwingTest {
    @TempDir
    Path folder;

    @Test
    void lostWorkIsRecoveredAndChangesOnDiskAreAsked() throws Exception {
        Path levels = Files.createDirectory(folder.resolve("levels"));
        String pictures = Path.of("build/pictures").toAbsolutePath().toString();
        try (VirtualDisplay display = VirtualDisplay.start()) {
            Map<String, String> environment =
                    Map.of("DISPLAY", display.name(), "WAYLAND_DISPLAY", "", "HOME", folder.toString());
            ChildJvm run = ChildJvm.run(
                    folder,
                    environment,
                    "-Djava.awt.headless=false",
                    FileWindowScenario.class.getName(),
                    levels.toString(),
                    pictures,
                    "LIGHT");
            List<String> steps = List.of("recovered: true", "kept mine: true", "told of the deletion: true");
            assertEquals(steps, run.out().lines().toList(), run.err());
        }
    }
}
