package nephele.editor.start;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import nephele.app.ChildJvm;
import nephele.app.VirtualDisplay;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The first room, from an empty level to a play of it, by mouse and keys alone. */
@Execution(ExecutionMode.SAME_THREAD)
class FirstRoomSwingTest {
    private static final List<String> STEPS = List.of(
            "01-guide",
            "02-room",
            "03-lamp",
            "04-exit",
            "05-cube-and-cloud",
            "06-portals",
            "saved first-room.json",
            "recorded true",
            "solved",
            "played, same selection: true",
            "closed");

    @TempDir
    Path folder;

    @Test
    void theRoomIsBuiltSavedCheckedSolvedAndPlayed() throws Exception {
        String pictures = Path.of("build/pictures/first-room").toAbsolutePath().toString();
        try (VirtualDisplay display = VirtualDisplay.ofSize("1280x800")) {
            Map<String, String> environment = Map.of(
                    "DISPLAY", display.name(),
                    "WAYLAND_DISPLAY", "",
                    "HOME", folder.toString(),
                    "XDG_DATA_HOME", folder.resolve("data").toString());
            ChildJvm run = ChildJvm.run(
                    folder,
                    environment,
                    "-Djava.awt.headless=false",
                    FirstRoomScenario.class.getName(),
                    folder.toString(),
                    pictures);
            assertEquals(STEPS, run.out().lines().toList(), run.err());
        }
        Level level =
                LevelFile.read(folder.resolve(FirstRoomScenario.OWN_LEVELS).resolve("first-room.json"));
        assertEquals(
                List.of(6, 1, 1, 1, 2),
                List.of(
                        level.solids().size(),
                        level.lights().size(),
                        level.bodies().size(),
                        level.environment().clouds().size(),
                        level.portals().size()));
        assertEquals(level.portals().get(0).id(), level.portals().get(1).linkedTo());
        assertTrue(level.player() != null && level.exits().size() == 1);
    }
}
