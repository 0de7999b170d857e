package nephele.editor.window.file;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.swing.Timer;
import nephele.editor.document.Registration;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.window.viewport.ViewportPanel;

/** Keeps a small picture of what the user saw last, some seconds after an edit: the viewport has drawn it anyway. */
final class JournalPictures implements AutoCloseable {
    private static final int DELAY_MILLIS = 2000;

    private final EditorSession session;
    private final ViewportPanel viewport;
    private final Executor background;
    private final Consumer<byte[]> keep;
    private final Timer timer;
    private final Registration registration;

    /** @param keep receives PNG files, on a thread of {@code background} */
    JournalPictures(EditorSession session, ViewportPanel viewport, Executor background, Consumer<byte[]> keep) {
        this.session = session;
        this.viewport = viewport;
        this.background = background;
        this.keep = keep;
        timer = new Timer(DELAY_MILLIS, event -> take());
        timer.setRepeats(false);
        registration = session.listen(change -> {
            if (change == SessionChange.DOCUMENT && session.document().isModified() && !timer.isRunning()) {
                timer.start();
            }
        });
    }

    /** Takes the picture now, unless something is dragged: it is then tried again later. */
    void take() {
        if (session.document().isDragging()) {
            timer.restart();
        } else {
            viewport.surface().visible().ifPresent(picture -> {
                BufferedImage small = small(picture, place());
                background.execute(() -> keep.accept(png(small)));
            });
        }
    }

    /** Returns the pane whose picture tells most: the first of the visible ones that is no plan. */
    private Rectangle place() {
        PaneLayout panes = session.panes();
        return panes.rectangles(session.viewport(), PaneLayout.GAP_PIXELS).stream()
                .filter(each -> panes.views().get(each.index()).kind() == PaneKind.PERSPECTIVE)
                .findFirst()
                .map(JournalPictures::rectangle)
                .orElseGet(() -> new Rectangle(
                        session.viewport().width(), session.viewport().height()));
    }

    private static Rectangle rectangle(PaneRectangle pane) {
        return new Rectangle(pane.x(), pane.y(), pane.width(), pane.height());
    }

    private static BufferedImage small(BufferedImage whole, Rectangle place) {
        Rectangle part = place.intersection(new Rectangle(whole.getWidth(), whole.getHeight()));
        BufferedImage cut = part.isEmpty() ? whole : whole.getSubimage(part.x, part.y, part.width, part.height);
        double fit = Math.min(
                (double) PicturedList.PICTURE_WIDTH / cut.getWidth(),
                (double) PicturedList.PICTURE_HEIGHT / cut.getHeight());
        int width = (int) Math.max(1, fit * cut.getWidth());
        int height = (int) Math.max(1, fit * cut.getHeight());
        BufferedImage small = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = small.createGraphics();
        try {
            graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            graphics.drawImage(cut, 0, 0, width, height, null);
        } finally {
            graphics.dispose();
        }
        return small;
    }

    private static byte[] png(BufferedImage picture) {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        try {
            ImageIO.write(picture, "png", png);
        } catch (IOException impossible) {
            throw new IllegalStateException("memory can be written to", impossible);
        }
        return png.toByteArray();
    }

    @Override
    public void close() {
        timer.stop();
        registration.close();
    }
}
