package nephele.app.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.Main;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Commands that open a window where the environment names a display that doesn't answer, or none that Swing can use. */
@Execution(ExecutionMode.SAME_THREAD)
class DeadDisplaySwingTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"play, :4242, ''", "scene, :4242, ''", "edit, :4242, ''", "edit, '', wayland-9"})
    void aDisplayThatCannotBeOpenedIsExplainedInOneLine(String command, String x11, String wayland) throws Exception {
        var environment = Map.of("DISPLAY", x11, "WAYLAND_DISPLAY", wayland, "HOME", folder.toString());
        var run = ChildJvm.run(folder, environment, Main.class.getName(), command);
        assertEquals(3, run.exitCode(), run.err());
        // On a busy machine a line says first that the command is still at work.
        var lines = run.err()
                .lines()
                .filter(line -> !line.startsWith("nephele " + command + ": at work for "))
                .toList();
        assertEquals(1, lines.size(), run.err());
        assertTrue(lines.get(0).startsWith("nephele " + command + ": no display can be opened: "), run.err());
        try (var files = Files.walk(folder)) {
            var left = files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .sorted()
                    .toList();
            assertEquals(List.of("child.err", "child.out"), left);
        }
    }
}
