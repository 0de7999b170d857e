package nephele.workshop.prove.editor;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.engine.level.Language;

/** A panel of a dialogue, laid out and painted without a window. */
public record PaintedPanel(JComponent panel) {
    /** Lays a panel out at its preferred size. */
    public PaintedPanel {
        panel.setSize(panel.getPreferredSize());
        for (int pass = 0; pass < 2; pass++) {
            layOut(panel);
        }
    }

    /** Returns the settings of a look. */
    public static EditorSettings settings(Theme theme, int percent, Language language) {
        return EditorSettings.DEFAULT
                .with(EditorSetting.THEME, theme)
                .with(EditorSetting.SCALE_PERCENT, percent)
                .with(EditorSetting.LANGUAGE, language);
    }

    /** Lays out a container and what is in it: without a window it does not do so itself. */
    static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** Returns the panel's picture. */
    public BufferedImage picture() {
        var picture = new BufferedImage(panel.getWidth(), panel.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        panel.paint(graphics);
        graphics.dispose();
        return picture;
    }

    /** Writes the picture into build/pictures. */
    public PaintedPanel write(String name) throws IOException {
        File file = new File("build/pictures/dialog-" + name + ".png");
        file.getParentFile().mkdirs();
        ImageIO.write(picture(), "png", file);
        return this;
    }

    /** Returns the texts that are cut off; paths of files are excepted. */
    public List<String> clipped() {
        return CutTexts.in(panel);
    }

    /** Returns the texts that are cut off; ids of the session's level and paths of files are excepted. */
    public List<String> clipped(EditorSession session) {
        return CutTexts.in(panel, session);
    }

    /** Returns all components of a type within a container. */
    public static <T extends Component> List<T> all(Container container, Class<T> type) {
        List<T> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (type.isInstance(child)) {
                found.add(type.cast(child));
            }
            if (child instanceof Container inner) {
                found.addAll(all(inner, type));
            }
        }
        return found;
    }
}
