package nephele.host.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import nephele.engine.scene.light.LevelLight;
import nephele.host.named.LevelName;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class FollowingBakeTest {
    private static final QualityChoice LOW = new QualityChoice("low", Map.of());

    @TempDir
    Path folder;

    private Path saved;
    private Path edited;

    /** A corner under the sky, and one with another wall. */
    @BeforeEach
    void write() throws IOException {
        saved = Files.writeString(folder.resolve("corner.json"), corner(3));
        edited = Files.writeString(folder.resolve("copy.tmp"), corner(4));
        Files.createDirectories(folder.resolve("cache"));
    }

    private static String corner(int wallMetres) {
        return "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {\"sky\": {\"kind\": \"constant\","
            + " \"radiance\": [1, 1, 1]}}, \"materials\": [{\"id\": \"m\"}], \"solids\": [{\"id\": \"f\", \"kind\":"
            + " \"box\", \"material\": \"m\", \"centre\": [0, -0.5, 0], \"size\": [3, 1, 3]},{\"id\": \"w\", \"kind\":"
            + " \"box\", \"material\": \"m\", \"centre\": [0, 1, -1], \"size\": [3, "
                + wallMetres + ", 1]}]}";
    }

    private Preparation.Prepared prepared(boolean hasFormerLight) {
        var name = new LevelName(saved.toString());
        return Preparation.beginUnbaked(
                        () -> name.openCopy(edited),
                        LOW,
                        () -> hasFormerLight ? FollowingBake.lightOf(name).orElse(null) : null)
                .get();
    }

    @Test
    void anEditIsDrawnUnderAnOpenSkyAndThenWithItsLight() {
        var prepared = prepared(true); // the level as saved was never baked
        assertEquals(saved.toString(), prepared.opened().file());
        assertEquals(0, prepared.scene().light().statics().all().size());
        try (var bake = FollowingBake.begin(prepared.scene(), prepared.opened().placed())) {
            assertTrue(LevelLight.isOf(bake.scene().light(), prepared.opened().placed()));
            assertEquals(100, bake.percent());
            assertTrue(bake.isDone());
        }
        var again = prepared(false);
        try (var bake = FollowingBake.begin(again.scene(), again.opened().placed())) {
            assertSame(again.scene(), bake.scene(), "the stored light is used at once");
        }
    }

    @Test
    void anEditIsDrawnWithTheLightOfTheSavedLevel() {
        var placed = new LevelName(saved.toString()).open().placed();
        var light = LevelLight.of(placed, share -> {});
        var prepared = prepared(true);
        assertNotSame(light, prepared.scene().light());
        assertTrue(LevelLight.isOf(prepared.scene().light(), placed));
        assertFalse(LevelLight.isOf(prepared.scene().light(), prepared.opened().placed()));
    }
}
