package nephele.editor.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import nephele.editor.action.Actions;
import nephele.editor.action.EditorCommands;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.Tools;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.text.Words;
import nephele.editor.tool.terrain.TerrainTool;
import nephele.engine.level.Language;
import nephele.engine.level.Terrain;
import nephele.engine.level.Terrain.Layer;
import nephele.workshop.prove.editor.CutTexts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The option bar offers the layers of the terrain while its tool is in use. */
@Execution(ExecutionMode.SAME_THREAD)
class LayerBoxSwingTest {
    private EditorSession session;
    private EditorPanel panel;

    @BeforeEach
    void open() {
        WindowLook.apply(EditorSettings.DEFAULT);
        DocumentFile.Opened opened = DocumentFile.open("levels/samples/terrain.json");
        session = new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
        EditorCommands commands = new EditorCommands(session, new WindowInterface(session), Actions.ALL);
        EditorSlots slots = new EditorSlots(
                null, new JLabel("outliner"), new JLabel("inspector"), new JTabbedPane(), List.of("undo"));
        panel = new EditorPanel(session, commands, slots);
        panel.layOut(new Dimension(1280, 800));
    }

    @AfterEach
    void close() {
        panel.close();
    }

    private static Stream<Component> all(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(child -> Stream.concat(
                        Stream.of(child), child instanceof Container inner ? all(inner) : Stream.empty()));
    }

    private Optional<LayerBox> box() {
        return all(panel)
                .filter(LayerBox.class::isInstance)
                .map(LayerBox.class::cast)
                .findFirst();
    }

    private void layers(List<Layer> layers) {
        session.document().edit(Words.same("layers"), level -> {
            Terrain said = level.terrains().get(0);
            return level.withTerrains(List.of(said.withLayers(layers)));
        });
    }

    @Test
    void aChoiceIsThatOfTheBrushAndPaints() {
        assertFalse(box().isPresent(), "another tool is in use");
        session.use(TerrainTool.ENTRY);
        LayerBox box = box().orElseThrow();
        List<Layer> said = session.document().level().terrains().get(0).layers();
        assertEquals(said.size(), box.getItemCount());
        assertEquals(0, box.getSelectedIndex());
        assertEquals(Effect.RAISE, session.options().terrainBrush().effect(), "showing chooses nothing");
        box.setSelectedIndex(2);
        assertEquals(2, session.options().terrainBrush().layer());
        assertEquals(Effect.PAINT, session.options().terrainBrush().effect());
        session.options().terrainBrush(session.options().terrainBrush().ofLayer(1));
        session.use(Tools.ALL.get(0));
        session.use(TerrainTool.ENTRY);
        assertEquals(1, box().orElseThrow().getSelectedIndex());
    }

    @Test
    void itFollowsTheLayersAndIsLeftOutWithoutAChoice() {
        session.use(TerrainTool.ENTRY);
        List<Layer> said = session.document().level().terrains().get(0).layers();
        session.options().terrainBrush(session.options().terrainBrush().ofLayer(2));
        layers(said.subList(0, 2));
        assertEquals(2, box().orElseThrow().getItemCount());
        assertEquals(-1, box().orElseThrow().getSelectedIndex(), "the chosen layer is gone");
        layers(said.subList(0, 1));
        assertFalse(box().isPresent());
        session.document().undo();
        assertTrue(box().isPresent());
    }

    @Test
    void nothingIsCutOffInAnyLanguage() {
        session.use(TerrainTool.ENTRY);
        for (Language language : Language.values()) {
            session.settings(session.settings().with(EditorSetting.LANGUAGE, language));
            panel.layOut(panel.getSize());
            assertTrue(box().orElseThrow().getWidth() > 0);
            assertEquals(
                    WindowText.LAYER_TO_PAINT.in(language), box().orElseThrow().getToolTipText());
            assertEquals(List.of(), CutTexts.in(panel, session), language.title());
        }
    }
}
