package nephele.editor.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import nephele.editor.action.ScriptInterface;
import nephele.editor.action.ScriptRunner;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.FileServices;
import nephele.editor.terrain.PaintedLevel;
import nephele.editor.text.EditorRefusal;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Terrain;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A level that is saved to another folder has its files there, and its session reads those. */
class SavedElsewhereTest {
    @TempDir
    Path folder;

    private Path working;
    private Path elsewhere;
    private EditorSession session;

    /** A new level whose terrain has its heights in the folder in which the editor was started. */
    @BeforeEach
    void open() throws Exception {
        working = Files.createDirectories(folder.resolve("working/terrain")).getParent();
        elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        BufferedImage grey = new BufferedImage(33, 33, BufferedImage.TYPE_USHORT_GRAY);
        ImageIO.write(grey, "png", working.resolve("terrain/own.png").toFile());
        session = new EditorSession(
                DocumentFile.UNTITLED,
                DocumentFile.untitled().level(),
                LevelAssets.beside(working.resolve("untitled.json")),
                EditorSettings.DEFAULT);
        session.fileServices(FileServices.of(FiledSession.files(folder)));
        run("add terrains at=0,0,0", "set heightMap to=terrain/own.png");
    }

    private void run(String... lines) throws EditorRefusal {
        for (String line : lines) {
            new ScriptRunner(session, new ScriptInterface(() -> null)).run(line);
        }
    }

    private static long errors(EditorSession of) {
        return ProblemSearch.of(of.document().level(), of.assets()).stream()
                .filter(problem -> problem.severity() == LevelProblem.Severity.ERROR)
                .count();
    }

    private String save(String name) {
        return "save-as file=\"" + elsewhere.resolve(name) + "\"";
    }

    @Test
    void itsFilesAreTakenAlong() throws Exception {
        run(save("hills.json"));
        assertArrayEquals(
                Files.readAllBytes(working.resolve("terrain/own.png")),
                Files.readAllBytes(elsewhere.resolve("terrain/own.png")));
        assertEquals(0, errors(new PaintedLevel(elsewhere.resolve("hills.json")).open()));
        assertFalse(Files.exists(elsewhere.resolve("textures")), "what comes with the game is not copied");
    }

    @Test
    void aTerrainPaintedThenKeepsItsPictureAlsoInUndoneStates() throws Exception {
        run(save("hills.json"));
        Terrain before = PaintedLevel.terrain(session);
        for (int i = 0; i < 5; i++) {
            run("terrain-stroke effect=raise from=" + 20 * i + ",0,0 to=" + 20 * i + ",0,9 radius=20 strength=1");
        }
        assertEquals(0, errors(session));
        Terrain painted = PaintedLevel.terrain(session);
        run("save");
        EditorSession again = new PaintedLevel(elsewhere.resolve("hills.json")).open();
        assertEquals(painted, PaintedLevel.terrain(again));
        assertEquals(0, errors(again));
        run("undo", "undo", "undo", "undo");
        assertEquals(0, errors(session));
        run("undo");
        assertEquals(before, PaintedLevel.terrain(session));
        assertEquals(0, errors(session));
    }

    @Test
    void anUndoneStateThatNamesAFileOfTheFormerFolderIsSavedWithIt() throws Exception {
        run("set heightMap to=terrain/hills.png", save("hills.json"));
        assertFalse(Files.exists(elsewhere.resolve("terrain/own.png")));
        run("undo");
        assertEquals(0, errors(session));
        run("save");
        assertTrue(Files.exists(elsewhere.resolve("terrain/own.png")));
        assertEquals(0, errors(new PaintedLevel(elsewhere.resolve("hills.json")).open()));
    }

    @Test
    void anotherFileOfTheNameStaysAndTheLevelIsNotSaved() throws IOException {
        Path other = Files.createDirectories(elsewhere.resolve("terrain")).resolve("own.png");
        Files.writeString(other, "another file");
        String said =
                assertThrows(EditorRefusal.class, () -> run(save("hills.json"))).getMessage();
        assertTrue(said.contains("own.png") && said.contains("another folder"), said);
        assertEquals("another file", Files.readString(other));
        assertFalse(Files.exists(elsewhere.resolve("hills.json")));
        assertTrue(session.file().path().isEmpty());
    }
}
