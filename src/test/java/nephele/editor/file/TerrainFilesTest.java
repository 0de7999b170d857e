package nephele.editor.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneOffset;
import nephele.editor.action.ActionFailure;
import nephele.editor.action.ScriptDesk;
import nephele.editor.action.ScriptRunner;
import nephele.editor.save.LevelPackage;
import nephele.editor.save.journal.CrashedEditor;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorSession;
import nephele.editor.terrain.PaintedLevel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The maps of strokes survive a crash, a save, and the way through a package. */
class TerrainFilesTest {
    private static final InstantSource CLOCK = InstantSource.fixed(Instant.parse("2026-01-02T14:02:05Z"));
    private static final String STROKE = "terrain-stroke effect=raise from=-9,0,4 to=12,0,4 radius=6 strength=1";

    @TempDir
    Path folder;

    private PaintedLevel level;
    private EditorSession session;

    @BeforeEach
    void open() throws IOException {
        level = PaintedLevel.in(Files.createDirectory(folder.resolve("level")));
        session = level.open();
    }

    private static void run(EditorSession session, String line) {
        try {
            new ScriptRunner(session, new ScriptDesk(() -> null)).run(line);
        } catch (ActionFailure failure) {
            throw new AssertionError(failure.told().english(), failure);
        }
    }

    private short[] heights(EditorSession of) {
        return PaintedLevel.map(of).values();
    }

    @Test
    void aStrokeThatWasNeverSavedIsRecovered() throws IOException {
        SessionJournal journal =
                new SessionJournal(session, new JournalFolder(folder.resolve("running"), CLOCK), trouble -> {});
        short[] flat = heights(session).clone();
        run(session, STROKE);
        short[] painted = heights(session).clone();
        assertTrue(journal.flush());
        JournalFolder left = CrashedEditor.copy(folder.resolve("running"), folder.resolve("left"));
        journal.close();
        EditorSession next = level.open();
        assertArrayEquals(flat, heights(next));
        try (SessionJournal offered = new SessionJournal(next, left, trouble -> {})) {
            new RecoveryList(offered, offered.lost(), CLOCK.instant(), ZoneOffset.UTC).recover(0);
            assertArrayEquals(painted, heights(next));
            next.document().undo();
            assertArrayEquals(flat, heights(next));
        }
    }

    @Test
    void aLevelThatIsSavedElsewhereTakesItsMapAlong() throws IOException {
        run(session, STROKE);
        short[] painted = heights(session).clone();
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("other.json");
        run(session, "save-as file=" + elsewhere);
        session.maps().discard();
        assertArrayEquals(painted, heights(new PaintedLevel(elsewhere).open()));
        assertArrayEquals(painted, heights(session));
    }

    @Test
    void aSavedStrokeIsOpenedAgainAndGoesIntoPackages() {
        run(session, STROKE);
        short[] painted = heights(session).clone();
        run(session, "save");
        session.maps().discard();
        EditorSession again = level.open();
        assertArrayEquals(painted, heights(again));
        Path zip = folder.resolve("level.zip");
        LevelPackage.export(zip, "level.json", again.document().level(), again.assets());
        Path unpacked = LevelPackage.extract(zip, folder.resolve("unpacked"));
        EditorSession elsewhere = new PaintedLevel(unpacked).open();
        assertNotEquals(level.file(), unpacked);
        assertEquals(PaintedLevel.terrain(again), PaintedLevel.terrain(elsewhere));
        assertArrayEquals(painted, heights(elsewhere));
    }
}
