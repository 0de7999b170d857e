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
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import nephele.editor.action.ScriptInterface;
import nephele.editor.action.ScriptRunner;
import nephele.editor.save.LevelPackage;
import nephele.editor.save.journal.CrashedEditor;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorSession;
import nephele.editor.terrain.PaintedLevel;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.Terrain;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The maps of strokes survive a crash, a save, and the way through a package. */
class TerrainFilesTest {
    private static final InstantSource CLOCK = InstantSource.fixed(Instant.parse("2026-01-02T14:02:05Z"));
    private static final String LINE = " from=-9,0,4 to=12,0,4 radius=6 strength=1";
    private static final String RAISE = "terrain-stroke effect=raise" + LINE;
    private static final String PAINT = "terrain-stroke effect=paint layer=rock" + LINE;

    @TempDir
    Path folder;

    private PaintedLevel level;
    private EditorSession session;

    @BeforeEach
    void open() throws IOException {
        level = PaintedLevel.layered(Files.createDirectory(folder.resolve("level")));
        session = level.open();
    }

    private static void run(EditorSession session, String line) {
        try {
            new ScriptRunner(session, new ScriptInterface(() -> null)).run(line);
        } catch (EditorRefusal failure) {
            throw new AssertionError(failure.words().english(), failure);
        }
    }

    /** Returns the contents of a terrain's height map and, if there is one, its layer map. */
    private static List<byte[]> maps(EditorSession of) {
        Terrain said = PaintedLevel.terrain(of);
        return Stream.of(said.heightMap(), said.layerMap())
                .filter(Objects::nonNull)
                .map(of.assets()::bytes)
                .toList();
    }

    private static void assertMaps(List<byte[]> expected, EditorSession of) {
        List<byte[]> found = maps(of);
        assertEquals(expected.size(), found.size());
        for (int i = 0; i < found.size(); i++) {
            assertArrayEquals(expected.get(i), found.get(i));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {RAISE, PAINT})
    void aStrokeThatWasNeverSavedIsRecovered(String stroke) throws IOException {
        SessionJournal journal =
                new SessionJournal(session, new JournalFolder(folder.resolve("running"), CLOCK), trouble -> {});
        List<byte[]> flat = maps(session);
        run(session, stroke);
        List<byte[]> painted = maps(session);
        assertTrue(journal.flush());
        JournalFolder left = CrashedEditor.copy(folder.resolve("running"), folder.resolve("left"));
        journal.close();
        EditorSession next = level.open();
        assertMaps(flat, next);
        try (SessionJournal offered = new SessionJournal(next, left, trouble -> {})) {
            new RecoveryList(offered, offered.lost(), CLOCK.instant(), ZoneOffset.UTC).recover(0);
            assertMaps(painted, next);
            next.document().undo();
            assertMaps(flat, next);
        }
    }

    @Test
    void aLevelThatIsSavedElsewhereTakesItsMapAlong() throws IOException {
        run(session, RAISE);
        run(session, PAINT);
        List<byte[]> painted = maps(session);
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("other.json");
        run(session, "save-as file=" + elsewhere);
        session.maps().discard();
        assertMaps(painted, new PaintedLevel(elsewhere).open());
        assertMaps(painted, session);
    }

    @Test
    void aSavedStrokeIsOpenedAgainAndGoesIntoPackages() throws EditorRefusal {
        run(session, RAISE);
        run(session, PAINT);
        List<byte[]> painted = maps(session);
        run(session, "save");
        session.maps().discard();
        EditorSession again = level.open();
        assertMaps(painted, again);
        Path zip = folder.resolve("level.zip");
        LevelPackage.export(zip, "level.json", again.document().level(), again.assets());
        Path unpacked = LevelPackage.extract(zip, folder.resolve("unpacked"));
        EditorSession elsewhere = new PaintedLevel(unpacked).open();
        assertNotEquals(level.file(), unpacked);
        assertEquals(PaintedLevel.terrain(again), PaintedLevel.terrain(elsewhere));
        assertMaps(painted, elsewhere);
    }
}
