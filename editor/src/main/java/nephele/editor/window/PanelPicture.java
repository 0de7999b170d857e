package nephele.editor.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/** The picture of the whole editor, the viewport included. */
public final class PanelPicture {
    private PanelPicture() {}

    /** Lays a panel out at a size; without a display nothing else does. */
    public static void layOut(EditorPanel panel, Dimension size) {
        panel.setSize(size);
        // The second pass knows the widths that the first one gave, the third the splitters that follow from them.
        for (int pass = 0; pass < 3; pass++) {
            invalidate(panel);
            layOut(panel);
        }
    }

    private static void invalidate(Container container) {
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                invalidate(inner);
            }
        }
        container.invalidate();
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** Paints a panel that has been laid out, after its viewport was drawn with all edits taken over. */
    public static BufferedImage of(EditorPanel panel) {
        panel.viewport().picture();
        return asShown(panel);
    }

    /** Paints a panel as it is shown: the viewport with its last picture, which waits for nothing. */
    static BufferedImage asShown(EditorPanel panel) {
        int width = Math.max(1, panel.getWidth());
        int height = Math.max(1, panel.getHeight());
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        try {
            panel.printAll(graphics);
        } finally {
            graphics.dispose();
        }
        return picture;
    }
}
