package nephele.editor.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import javax.swing.JTable;
import javax.swing.LookAndFeel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import nephele.editor.document.Selection;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.settings.EditorSetting;
import nephele.editor.settings.EditorSettings;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;

/** The panels over a level of the game, painted without a window. */
class PanelPictureSwingTest {
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

    private static BufferedImage picture(List<JPanel> panels, int scale) {
        int width = 320 * scale;
        int height = 620 * scale;
        var image = new BufferedImage(width * panels.size(), height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        for (JPanel panel : panels) {
            panel.setSize(width, height);
            layOut(panel);
            panel.paint(graphics);
            graphics.translate(width, 0);
        }
        graphics.dispose();
        return image;
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
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

    private static void paint(String theme, int scale) throws Exception {
        EditorSession session = session();
        UIManager.put("defaultFont", new Font("SansSerif", Font.PLAIN, 12 * scale));
        UIManager.setLookAndFeel("com.formdev.flatlaf.Flat" + theme + "Laf");
        List<JPanel> panels = List.of(
                new OutlinerPanel(session, ref -> {}),
                new InspectorPanel(session, (field, current) -> Optional.empty()),
                new HistoryPanel(session));
        session.document().select(Selection.of(new EntityRef("materials", "lamp")));
        for (Language language : Language.values()) {
            session.settings(session.settings().with(EditorSetting.LANGUAGE, language));
            BufferedImage image = picture(panels, scale);
            File file = new File("build/pictures/editor-panel-" + theme.toLowerCase(java.util.Locale.ROOT) + "-"
                    + scale * 100 + "-" + language.name().toLowerCase(java.util.Locale.ROOT) + ".png");
            Files.createDirectories(file.toPath().getParent());
            ImageIO.write(image, "png", file);
            assertTrue(image.getRaster().getDataBuffer().getSize() > 0);
        }
    }

    @Test
    void thePanelsArePaintedInEachThemeSizeAndLanguage() throws Exception {
        List<Exception> failures = new ArrayList<>();
        LookAndFeel before = UIManager.getLookAndFeel();
        onEventThread(() -> {
            try {
                for (String theme : List.of("Dark", "Light")) {
                    paint(theme, 1);
                    paint(theme, 2);
                }
                UIManager.put("defaultFont", null);
                UIManager.setLookAndFeel(before);
            } catch (Exception failed) {
                failures.add(failed);
            }
        });
        assertEquals(List.of(), failures);
    }

    @Test
    void anEditByHandIsOneStepAndSelectionGoesBothWays() throws Exception {
        EditorSession session = session();
        List<Object> seen = new ArrayList<>();
        onEventThread(() -> {
            var outliner = new OutlinerPanel(session, ref -> {});
            var inspector = new InspectorPanel(session, (field, current) -> Optional.empty());
            JTable table = all(outliner, JTable.class).get(0);
            outliner.search("type:material lamp");
            seen.add(table.getRowCount());
            table.setRowSelectionInterval(1, 1);
            seen.add(session.document().selection());
            JCheckBox mirror = all(inspector, JCheckBox.class).get(0);
            mirror.doClick();
            seen.add(session.document().history().labels().size());
            seen.add(all(inspector, JCheckBox.class).get(0) == mirror);
            session.document().undo();
            seen.add(mirror.isSelected());
            session.document().select(Selection.NONE);
            seen.add(table.getSelectedRowCount());
        });
        assertEquals(List.of(3, Selection.of(new EntityRef("materials", "lamp")), 1, true, false, 0), seen);
    }
}
