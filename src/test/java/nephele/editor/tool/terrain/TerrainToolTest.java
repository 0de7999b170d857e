package nephele.editor.tool.terrain;

import static nephele.editor.tool.terrain.PlanHand.at;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import nephele.editor.action.ScriptInterface;
import nephele.editor.action.ScriptRunner;
import nephele.editor.document.NoteEdits;
import nephele.editor.pane.Mark;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.terrain.PaintedLevel;
import nephele.editor.terrain.TerrainBrush;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.terrain.TerrainText;
import nephele.editor.text.EditorRefusal;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A drag of the terrain tool shows its heights at once, and is one step whose map is a new file beside the level. */
class TerrainToolTest {
    @TempDir
    Path folder;

    private PaintedLevel level;
    private EditorSession session;

    @BeforeEach
    void open() throws IOException {
        level = PaintedLevel.in(folder);
        session = level.open();
        session.use(TerrainTool.ENTRY);
        session.options().terrainBrush(new TerrainBrush(Effect.RAISE, 8, 1));
    }

    private void stroke(double fromX, double toX, Modifier... held) {
        new PlanHand(session).stroke(fromX, toX, held);
    }

    private int value(int column, int row) {
        return PaintedLevel.map(session).value(column, row);
    }

    private String map() {
        return PaintedLevel.terrain(session).heightMap();
    }

    @Test
    void aDragShowsItsHeightsAndMakesOneStepAndOneFile() throws IOException {
        Level before = session.document().level();
        session.drag().press(at(0, 0));
        int first = value(16, 16);
        assertEquals(20_000 + Math.round(1.6 / 10 * 65_535), first);
        session.drag().move(at(2, 0));
        assertTrue(value(16, 16) > first, "a dab at each quarter of the radius");
        assertTrue(level.painted().isEmpty(), "nothing is written before the end");
        session.drag().release(at(2, 0));
        assertEquals(Set.of(map()), level.painted().keySet());
        assertEquals(List.of(Effect.RAISE.title()), session.document().history().labels());
        assertEquals(map(), LevelFile.read(saved()).terrains().get(0).heightMap());
        session.document().undo();
        assertSame(before, session.document().level());
    }

    private Path saved() {
        session.saved(session.file());
        Path copy = folder.resolve("copy.json");
        LevelFile.save(copy, session.document().level());
        return copy;
    }

    @Test
    void undoAndRedoFindEachMapByteForByte() throws IOException {
        byte[] original = Files.readAllBytes(folder.resolve("flat.png"));
        short[] flat = PaintedLevel.map(session).values().clone();
        stroke(-4, 4);
        var once = level.painted();
        short[] first = PaintedLevel.map(session).values().clone();
        stroke(-4, 4, Modifier.SHIFT);
        short[] second = PaintedLevel.map(session).values().clone();
        assertNotEquals(first[16 * 33 + 16], second[16 * 33 + 16]);
        session.document().undo();
        assertArrayEquals(first, PaintedLevel.map(session).values());
        assertEquals(once.get(map()), level.painted().get(map()));
        session.document().undo();
        assertEquals("flat.png", map());
        assertArrayEquals(flat, PaintedLevel.map(session).values());
        assertArrayEquals(original, Files.readAllBytes(folder.resolve("flat.png")));
        session.document().redo();
        session.document().redo();
        assertArrayEquals(second, PaintedLevel.map(session).values());
    }

    @Test
    void escapeTakesAStrokeBack() throws IOException {
        Level before = session.document().level();
        session.drag().press(at(0, 0));
        session.drag().move(at(6, 0));
        assertTrue(session.drag().cancel());
        session.drag().release(at(6, 0));
        assertSame(before, session.document().level());
        assertFalse(session.document().history().canUndo());
        assertTrue(level.painted().isEmpty());
    }

    @Test
    void aStrokeThatChangesNothingIsNoStep() throws IOException {
        session.options().terrainBrush(new TerrainBrush(Effect.FLATTEN, 8, 1));
        stroke(-4, 4);
        assertFalse(session.document().history().canUndo());
        assertFalse(session.document().isDragging());
        assertTrue(level.painted().isEmpty());
    }

    @Test
    void aSavedLevelKeepsItsMapAndLeavesNoOthers() throws IOException {
        stroke(-4, 4);
        stroke(-10, -6);
        String kept = map();
        LevelFile.save(level.file(), session.document().level());
        session.saved(session.file().asOfNow());
        stroke(6, 10);
        assertEquals(3, level.painted().size());
        short[] second =
                HeightMap.read(kept, Files.readAllBytes(folder.resolve(kept))).values();
        session.maps().discard();
        assertEquals(Set.of(kept), level.painted().keySet());
        assertArrayEquals(second, PaintedLevel.map(level.open()).values());
    }

    @Test
    void aPreviewIsNeverAFile() {
        session.drag().press(at(0, 0));
        HeightMap visible = PaintedLevel.map(session);
        byte[] asked = session.assets().bytes(map());
        assertArrayEquals(visible.values(), HeightMap.read(map(), asked).values());
        assertTrue(session.assets().exists(map()));
        session.drag().cancel();
    }

    @Test
    void theRingLiesOnTheGround() {
        session.tool().moved(at(0, 0));
        List<Mark> marks = session.tool().marks();
        assertEquals(65, marks.size());
        Mark.Line side = (Mark.Line) marks.get(0);
        assertEquals(8, Math.hypot(side.from().x(), side.from().z()), 1e-9);
        assertEquals(20_000 / 6553.5 + 0.08, side.from().y(), 1e-6);
        assertTrue(
                session.tool().hint().english().startsWith("Raise Terrain: radius 8 m, strength 100 %, height 3.05"));
        session.drag().press(at(0, 0));
        Mark.Handle middle = (Mark.Handle) session.tool().marks().get(64);
        assertEquals(20_000 / 6553.5 + 1.6, middle.at().y(), 1e-3);
        session.drag().cancel();
        session.tool().left();
        assertEquals(List.of(), session.tool().marks());
    }

    @Test
    void beyondTheTerrainAndOnALockedOneItSaysWhy() {
        session.drag().press(at(39, 29));
        session.drag().release(at(39, 29));
        assertEquals(TerrainText.NO_TERRAIN.words(), session.status());
        EntityRef hills = new EntityRef("terrains", "hills");
        session.document().edit(session.status(), before -> NoteEdits.locked(before, List.of(hills)));
        stroke(-4, 4);
        assertEquals(TerrainText.LOCKED.with("hills"), session.status());
        assertEquals("flat.png", map());
    }

    @Test
    void scriptsPaintByNumbersAndSayWhatIsWrong() throws EditorRefusal {
        ScriptRunner script = new ScriptRunner(session, new ScriptInterface(() -> null));
        script.run("terrain-stroke effect=lower from=-4,0,0 to=4,0,0 radius=8 strength=1");
        int lowered = value(16, 16);
        assertTrue(lowered < 20_000);
        session.document().undo();
        stroke(-4, 4, Modifier.SHIFT);
        assertEquals(lowered, value(16, 16), "the same stroke by hand");
        script.run("terrain-smooth");
        script.run("terrain-larger");
        assertEquals(Effect.SMOOTH, session.options().terrainBrush().effect());
        assertEquals(8 * Math.sqrt(2), session.options().terrainBrush().radiusMetres(), 1e-12);
        assertFailure(script, "terrain-stroke effect=melt from=0,0,0", "there is no effect 'melt'");
        assertFailure(script, "terrain-stroke from=0,0,0 terrain=sea", "there is no terrain 'sea'");
    }

    private static void assertFailure(ScriptRunner script, String line, String begin) {
        try {
            script.run(line);
        } catch (EditorRefusal failure) {
            assertTrue(
                    failure.words().english().startsWith(begin), failure.words().english());
            return;
        }
        throw new AssertionError(line + " succeeded");
    }
}
