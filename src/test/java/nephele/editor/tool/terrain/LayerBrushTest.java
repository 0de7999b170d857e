package nephele.editor.tool.terrain;

import static nephele.editor.tool.terrain.PlanHand.at;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import nephele.editor.action.ScriptInterface;
import nephele.editor.action.ScriptRunner;
import nephele.editor.session.EditorSession;
import nephele.editor.terrain.PaintedLevel;
import nephele.editor.terrain.TerrainBrush;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.terrain.TerrainText;
import nephele.editor.text.EditorRefusal;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A drag that paints a layer shows it at once, and is one step whose layer map is a new file beside the level. */
class LayerBrushTest {
    @TempDir
    Path folder;

    private PaintedLevel level;
    private EditorSession session;
    private PlanHand hand;

    @BeforeEach
    void open() throws IOException {
        level = PaintedLevel.layered(folder);
        session = level.open();
        session.use(TerrainTool.ENTRY);
        hand = new PlanHand(session);
        choose(Effect.PAINT, 1);
    }

    private void choose(Effect effect, int layer) {
        session.options().terrainBrush(new TerrainBrush(effect, 8, 1, layer));
    }

    private String file() {
        return PaintedLevel.terrain(session).layerMap();
    }

    private LayerMap map() {
        return session.assets().decoded(file(), LayerMap.class, LayerMap::read);
    }

    @Test
    void aDragShowsItsPaintAndMakesOneStepAndOneFile() throws IOException {
        Level before = session.document().level();
        session.drag().press(at(0, 0));
        assertEquals(33, map().columns());
        assertEquals(1, map().layer(16, 16));
        assertEquals(255, map().weight(16, 16));
        assertEquals(Math.round(255 * 0.5625), map().weight(18, 16), "4 m from the middle");
        assertEquals(0, map().weight(20, 16), "8 m from the middle");
        session.drag().move(at(4, 0));
        assertEquals(255, map().weight(18, 16));
        assertTrue(level.painted().isEmpty(), "nothing is written before the end");
        session.drag().release(at(4, 0));
        assertEquals(Set.of(file()), level.painted().keySet());
        assertTrue(file().startsWith("terrain/hills-layers-"), file());
        assertEquals("flat.png", PaintedLevel.terrain(session).heightMap());
        assertEquals(List.of(Effect.PAINT.title()), session.document().history().labels());
        session.document().undo();
        assertSame(before, session.document().level());
    }

    @Test
    void undoAndRedoFindEachMapByteForByte() throws IOException {
        hand.stroke(-4, 4);
        String first = file();
        byte[] firstBytes = session.assets().bytes(first);
        byte[] firstTexels = map().texels().clone();
        hand.stroke(0, 4, Modifier.SHIFT);
        String second = file();
        byte[] secondBytes = session.assets().bytes(second);
        byte[] secondTexels = map().texels().clone();
        assertTrue(map().weight(18, 16) < 10, "erased");
        session.document().undo();
        assertEquals(first, file());
        assertArrayEquals(firstBytes, Files.readAllBytes(folder.resolve(first)));
        assertArrayEquals(firstTexels, map().texels());
        session.document().undo();
        assertNull(file());
        session.document().redo();
        session.document().redo();
        assertEquals(second, file());
        assertArrayEquals(secondBytes, Files.readAllBytes(folder.resolve(second)));
        assertArrayEquals(secondTexels, map().texels());
        assertEquals(List.of("Paint Layer", "Erase Paint"), labels());
    }

    private List<String> labels() {
        return session.document().history().labels().stream()
                .map(words -> words.english())
                .toList();
    }

    @Test
    void aSavedLevelShowsItsPaintAgain() {
        hand.stroke(-4, 4);
        byte[] texels = map().texels().clone();
        LevelFile.save(level.file(), session.document().level());
        session.saved(session.file().asOfNow());
        session.maps().discard();
        session = level.open();
        assertArrayEquals(texels, map().texels());
    }

    @Test
    void escapeAndStrokesWithoutEffectLeaveNothing() throws IOException {
        Level before = session.document().level();
        session.drag().press(at(0, 0));
        session.drag().move(at(6, 0));
        assertTrue(session.drag().cancel());
        session.drag().release(at(6, 0));
        assertSame(before, session.document().level());
        choose(Effect.ERASE, 1);
        hand.stroke(-4, 4);
        assertSame(before, session.document().level());
        assertFalse(session.document().history().canUndo());
        assertTrue(level.painted().isEmpty());
    }

    @Test
    void aWeakBrushOverAnotherLayerSaysWhyNothingHappens() {
        hand.stroke(-4, 4);
        session.options().terrainBrush(new TerrainBrush(Effect.PAINT, 8, 0.25, 0));
        hand.stroke(0, 0);
        assertEquals(TerrainText.TOO_WEAK.words(), session.status());
        assertEquals(1, labels().size());
    }

    @Test
    void theHintNamesTheLayer() {
        session.tool().moved(at(0, 0));
        assertEquals(
                "Paint rock: radius 8 m, strength 100 %", session.tool().hint().english());
        session.tool().moved(at(0, 0, Modifier.SHIFT));
        assertEquals(
                "Erase Paint: radius 8 m, strength 100 %", session.tool().hint().english());
        assertEquals(65, session.tool().marks().size());
    }

    @Test
    void erasingNeedsNoLayer() {
        hand.stroke(-4, 4);
        choose(Effect.ERASE, 5);
        hand.stroke(-4, 4);
        assertEquals(0, map().weight(16, 16));
    }

    @Test
    void aTerrainWithoutTheLayerSaysSo() {
        choose(Effect.PAINT, 5);
        hand.stroke(-4, 4);
        assertEquals(TerrainText.NO_LAYER.with("hills", 5), session.status());
        session.document()
                .edit(
                        session.status(),
                        before -> before.withTerrains(
                                List.of(before.terrains().get(0).withLayers(List.of()))));
        choose(Effect.PAINT, 0);
        hand.stroke(-4, 4);
        assertEquals(TerrainText.FEW_LAYERS.with("hills"), session.status());
        assertNull(file());
    }

    /** Heights can still be shaped over a layer map that cannot be read, which painting refuses to replace. */
    @Test
    void aMapThatCannotBeReadHidesNoGround() {
        session.document()
                .edit(
                        session.status(),
                        before -> before.withTerrains(
                                List.of(before.terrains().get(0).withLayerMap("none.png"))));
        hand.stroke(-4, 4);
        assertTrue(
                session.status().english().contains("none.png"),
                session.status().english());
        assertEquals("none.png", file());
        choose(Effect.RAISE, 0);
        hand.stroke(-4, 4);
        assertTrue(PaintedLevel.terrain(session).heightMap().startsWith("terrain/hills-"));
    }

    @Test
    void scriptsPaintByIndexOrMaterial() throws EditorRefusal {
        ScriptRunner script = new ScriptRunner(session, new ScriptInterface(() -> null));
        hand.stroke(-4, 4);
        String byHand = file();
        session.document().undo();
        script.run("terrain-stroke effect=paint layer=rock from=-4,0,0 to=4,0,0 radius=8 strength=1");
        assertEquals(byHand, file(), "the same stroke by hand");
        session.document().undo();
        script.run("terrain-stroke effect=paint layer=1 from=-4,0,0 to=4,0,0 radius=8 strength=1");
        assertEquals(byHand, file());
        script.run("terrain-stroke effect=erase from=-30,0,0 to=30,0,0 radius=30 strength=1");
        assertEquals(0, map().weight(16, 16));
        script.run("terrain-layer");
        assertEquals(0, session.options().terrainBrush().layer());
        script.run("terrain-layer layer=rock");
        assertEquals(1, session.options().terrainBrush().layer());
        script.run("terrain-erase");
        assertEquals(Effect.ERASE, session.options().terrainBrush().effect());
        EditorRefusal failure =
                assertThrows(EditorRefusal.class, () -> script.run("terrain-stroke effect=paint layer=2 from=0,0,0"));
        assertEquals("there is no layer '2': grass, rock", failure.words().english());
    }
}
