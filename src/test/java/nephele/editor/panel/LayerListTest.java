package nephele.editor.panel;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import nephele.editor.document.Selection;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.record.EntityRef;
import nephele.editor.record.ListEdit;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.terrain.PaintedLevel;
import nephele.editor.terrain.TerrainText;
import nephele.editor.text.Words;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;
import nephele.engine.level.terrain.LayerPaint;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits of a terrain's list of layers take the paint along, whose texels name layers by their index. */
class LayerListTest {
    private static final int SIDE = 12;

    @TempDir
    Path folder;

    private PaintedLevel level;
    private EditorSession session;
    private FieldChanges changes;
    private Words reported = Words.NONE;

    /** Opens a level with three layers, each painted on some texels with all weights; other texels have none. */
    @BeforeEach
    void open() throws IOException {
        level = PaintedLevel.layered(folder);
        LayerMap map = LayerMap.blank(SIDE, SIDE);
        for (int i = 0; i < SIDE * SIDE; i++) {
            map.texels()[2 * i] = (byte) (i % 3);
            map.texels()[2 * i + 1] = (byte) (i * 37);
        }
        Files.write(folder.resolve("paint.png"), map.png());
        Files.writeString(
                level.file(),
                Files.readString(level.file())
                        .replace(
                                "\"fromMetres\": 5}]",
                                "\"fromMetres\": 5}, {\"material\": \"sand\"}], \"layerMap\": \"paint.png\"")
                        .replace("{\"id\": \"rock\"}", "{\"id\": \"rock\"}, {\"id\": \"sand\"}"));
        inspect(level.open());
    }

    private void inspect(EditorSession opened) {
        session = opened;
        session.document().select(Selection.of(new EntityRef("terrains", "hills")));
        changes = new FieldChanges(session, words -> reported = words);
    }

    private InspectorField layer(int index) {
        return changes.fields().stream()
                .filter(field -> field.path().last().component().equals("layers")
                        && Integer.valueOf(index).equals(field.path().last().entry()))
                .findFirst()
                .orElseThrow();
    }

    private LayerMap map() {
        return session.assets().decoded(PaintedLevel.terrain(session).layerMap(), LayerMap.class, LayerMap::read);
    }

    /** Returns the weight of each material at a texel, the mixture under the paint as {@code bare}. */
    private Map<String, Integer> visible(int column, int row) {
        Map<String, Integer> weights = new TreeMap<>();
        int weight = map().weight(column, row);
        weights.put("bare", 255 - weight);
        if (weight > 0) {
            Terrain.Layer layer = PaintedLevel.terrain(session).layers().get(map().layer(column, row));
            weights.merge(layer.material(), weight, Integer::sum);
        }
        return weights;
    }

    private List<Map<String, Integer>> visible() {
        return java.util.stream.IntStream.range(0, SIDE * SIDE)
                .mapToObj(i -> visible(i % SIDE, i / SIDE))
                .toList();
    }

    @Test
    void movedAndNewLayersChangeNoPaint() {
        for (ListEdit edit : List.of(
                ListEdit.moved(0, 2),
                ListEdit.moved(2, 1),
                ListEdit.moved(1, 0),
                ListEdit.inserted(0),
                ListEdit.inserted(2))) {
            List<Map<String, Integer>> before = visible();
            String file = PaintedLevel.terrain(session).layerMap();
            changes.edit(layer(0), edit);
            assertEquals(before, visible(), edit.toString());
            assertNotEquals(file, PaintedLevel.terrain(session).layerMap(), edit.toString());
            LayerPaint.requireLayers(PaintedLevel.terrain(session), map());
        }
    }

    /** The weights of all layers at any place are those of before, in the new order. */
    @Test
    void theMixtureBetweenTexelsIsTheSame() {
        Terrain terrain = PaintedLevel.terrain(session);
        LayerPaint before = new LayerPaint(terrain, map());
        ListEdit edit = ListEdit.moved(0, 2);
        changes.edit(layer(0), edit);
        LayerPaint after = new LayerPaint(terrain, map());
        for (double x = -32; x <= 32; x += 3.7) {
            double[] old = {0.5, 0.2, 0.3};
            double[] now = new double[3];
            for (int i = 0; i < 3; i++) {
                now[edit.after(i)] = old[i];
            }
            before.over(x, x / 3, old);
            after.over(x, x / 3, now);
            for (int i = 0; i < 3; i++) {
                assertEquals(old[i], now[edit.after(i)], 1e-12, x + " m, layer " + i);
            }
        }
    }

    @Test
    void paintOfADeletedLayerIsErased() {
        List<Map<String, Integer>> before = visible();
        changes.remove(layer(1));
        assertEquals(
                List.of("grass", "sand"),
                PaintedLevel.terrain(session).layers().stream()
                        .map(Terrain.Layer::material)
                        .toList());
        for (int i = 0; i < SIDE * SIDE; i++) {
            Map<String, Integer> expected = before.get(i).containsKey("rock") ? Map.of("bare", 255) : before.get(i);
            assertEquals(expected, visible(i % SIDE, i / SIDE), "texel " + i);
        }
        changes.remove(layer(0));
        changes.remove(layer(0));
        LayerPaint.requireLayers(PaintedLevel.terrain(session), map());
    }

    @Test
    void undoAndRedoAreOneStepAndFindEachFileByteForByte() throws IOException {
        Level first = session.document().level();
        byte[] firstTexels = map().texels().clone();
        changes.remove(layer(0));
        Level second = session.document().level();
        byte[] secondTexels = map().texels().clone();
        var files = level.painted();
        changes.edit(layer(0), ListEdit.moved(0, 1));
        assertEquals(2, level.painted().size());
        assertEquals(2, session.document().history().labels().size());
        session.document().undo();
        assertSame(second, session.document().level());
        assertArrayEquals(secondTexels, map().texels());
        session.document().undo();
        assertSame(first, session.document().level());
        assertEquals("paint.png", PaintedLevel.terrain(session).layerMap());
        assertArrayEquals(firstTexels, map().texels());
        session.document().redo();
        assertSame(second, session.document().level());
        assertEquals(
                files.values().iterator().next(),
                level.painted().get(PaintedLevel.terrain(session).layerMap()));
        session.document().redo();
        assertArrayEquals(moved(secondTexels), map().texels());
    }

    /** Returns texels of two layers with the layers exchanged. */
    private static byte[] moved(byte[] texels) {
        byte[] moved = texels.clone();
        for (int i = 0; i < moved.length; i += 2) {
            moved[i] = (byte) (moved[i + 1] == 0 ? moved[i] : 1 - moved[i]);
        }
        return moved;
    }

    @Test
    void whatChangesNoTexelMakesNoFile() throws IOException {
        changes.add(
                changes.fields().stream()
                        .filter(field -> field.path().last().component().equals("layers"))
                        .findFirst()
                        .orElseThrow(),
                null);
        changes.remove(layer(3));
        assertEquals("paint.png", PaintedLevel.terrain(session).layerMap());
        assertEquals(Map.of(), level.painted());
        assertEquals(2, session.document().history().labels().size());
    }

    @Test
    void aLevelWithoutAFolderRefusesAndAFullListStays() {
        Level painted = session.document().level();
        inspect(new EditorSession(DocumentFile.UNTITLED, painted, session.assets(), EditorSettings.DEFAULT));
        changes.remove(layer(0));
        assertEquals(TerrainText.SAVE_FIRST.words(), reported);
        assertSame(painted, session.document().level());
        inspect(level.open());
        for (int i = 0; i < 7; i++) {
            changes.edit(layer(0), ListEdit.inserted(0));
        }
        assertEquals(8, PaintedLevel.terrain(session).layers().size());
        assertNotEquals(Words.NONE, reported);
    }

    @Test
    void aMapThatCannotBeReadStays() throws IOException {
        Files.write(folder.resolve("paint.png"), Arrays.copyOf(new byte[] {1}, 40));
        inspect(level.open());
        changes.remove(layer(0));
        assertEquals("paint.png", PaintedLevel.terrain(session).layerMap());
        assertEquals(2, PaintedLevel.terrain(session).layers().size());
    }
}
