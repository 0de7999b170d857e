package nephele.editor.window;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.image.BufferedImage;
import javax.swing.SwingUtilities;

/** The picture of the whole editor, the viewport's canvas included, whichever surface it has. */
public final class PanelPicture {
    private PanelPicture() {}

    /** Paints a panel that has been laid out. */
    public static BufferedImage of(EditorPanel panel) {
        int width = Math.max(1, panel.getWidth());
        int height = Math.max(1, panel.getHeight());
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        try {
            panel.printAll(graphics);
            Component viewport = panel.viewport().surface().component();
            Point at = SwingUtilities.convertPoint(viewport, 0, 0, panel);
            graphics.drawImage(
                    panel.viewport().picture(), at.x, at.y, viewport.getWidth(), viewport.getHeight(), null);
        } finally {
            graphics.dispose();
        }
        return picture;
    }
}
