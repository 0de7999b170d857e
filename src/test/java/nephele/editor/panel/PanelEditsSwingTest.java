package nephele.editor.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import nephele.editor.document.Selection;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSettings;
import nephele.editor.window.WindowLook;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The panels over a level of the game, without a window. */
@Execution(ExecutionMode.SAME_THREAD)
class PanelEditsSwingTest {
    private record NoAssets() implements AssetSource {
        @Override
        public byte[] bytes(String assetId) throws AssetException {
            throw new IllegalStateException(assetId);
        }

        @Override
        public boolean exists(String assetId) {
            return false;
        }
    }

    private static EditorSession session() throws Exception {
        Path file = Path.of("levels/02-first-shot.json");
        Level level = LevelJson.read(file.toString(), Files.readAllBytes(file));
        return new EditorSession(DocumentFile.UNTITLED, level, new NoAssets(), EditorSettings.DEFAULT);
    }

    private static void onEventThread(Runnable action) throws Exception {
        SwingUtilities.invokeAndWait(action);
    }

    private static <T> List<T> all(Container container, Class<T> type) {
        List<T> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (type.isInstance(child)) {
                found.add(type.cast(child));
            } else if (child instanceof Container inner) {
                found.addAll(all(inner, type));
            }
        }
        return found;
    }

    @Test
    void anEditByHandIsOneStepAndSelectionGoesBothWays() throws Exception {
        EditorSession session = session();
        List<Object> observed = new ArrayList<>();
        onEventThread(() -> {
            var outliner = new OutlinerPanel(session, ref -> {}, refs -> {});
            var inspector = new InspectorPanel(session, (field, current) -> Optional.empty());
            JTable table = all(outliner, JTable.class).get(0);
            outliner.search("type:material lamp");
            observed.add(table.getRowCount());
            table.setRowSelectionInterval(1, 1);
            observed.add(session.document().selection());
            JCheckBox mirror = all(inspector, JCheckBox.class).get(0);
            mirror.doClick();
            observed.add(session.document().history().labels().size());
            observed.add(all(inspector, JCheckBox.class).get(0) == mirror);
            session.document().undo();
            observed.add(mirror.isSelected());
            session.document().select(Selection.NONE);
            observed.add(table.getSelectedRowCount());
        });
        assertEquals(List.of(3, Selection.of(new EntityRef("materials", "lamp")), 1, true, false, 0), observed);
    }

    @Test
    void exposureIsANumberOrAutomatic() throws Exception {
        EditorSession session = session();
        Exposure written = session.document().level().environment().exposureStops();
        List<Object> observed = new ArrayList<>();
        onEventThread(() -> {
            var inspector = new InspectorPanel(session, (field, current) -> Optional.empty());
            JCheckBox auto = all(inspector, JCheckBox.class).stream()
                    .filter(box -> box.getText().equals("Automatic"))
                    .findFirst()
                    .orElseThrow();
            observed.add(auto.isSelected());
            auto.doClick();
            observed.add(session.document().level().environment().exposureStops());
            auto.doClick();
            observed.add(session.document().level().environment().exposureStops());
            session.document().undo();
            observed.add(auto.isSelected());
            session.document().undo();
            observed.add(session.document().level().environment().exposureStops());
        });
        assertEquals(List.of(false, Exposure.AUTO, Exposure.NEUTRAL, true, written), observed);
    }

    /** Every editor ends within the panel, also where the panel is as narrow as a window of 800 points makes it. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void nothingOfTheInspectorReachesBeyondIt(int scale) throws Exception {
        EditorSession session = session();
        onEventThread(() -> {
            WindowLook.apply(session.settings().with(EditorSetting.SCALE_PERCENT, 100 * scale));
            var inspector = new InspectorPanel(session, (field, current) -> Optional.empty());
            inspector.setSize(scale * 280, scale * 400);
            layOut(inspector);
            layOut(inspector);
            for (Component part :
                    all(inspector, WidthTrackingPanel.class).get(0).getComponents()) {
                int room = part.getParent().getWidth();
                assertTrue(part.getX() + part.getWidth() <= room, () -> part + " ends beyond " + room);
            }
            inspector.close();
            WindowLook.apply(session.settings());
        });
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }
}
