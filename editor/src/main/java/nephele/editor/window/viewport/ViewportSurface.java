package nephele.editor.window.viewport;

import java.awt.Color;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.KeyListener;
import java.awt.event.MouseAdapter;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.Timer;
import nephele.editor.window.viewport.SurfaceDrawing.Drawn;
import nephele.editor.window.viewport.SurfacePainter.Painting;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlKind;
import nephele.engine.render.gl.GlUnavailableException;

/**
 * A component that shows what a {@link SurfacePainter} draws. A thread of its own, which has the OpenGL context, draws
 * offscreen; meanwhile the component shows its last picture, and after a second how long the next one has taken. So Swing
 * waits for no level, table or shader, however long these take. It also works without a display, where only {@link #picture}
 * draws.
 */
public final class ViewportSurface implements AutoCloseable {
    private static final int LOOK_MILLIS = 250;
    private static final int PLATE_POINTS = 10;
    private static final Color PLATE = new Color(0, 0, 0, 170);
    private static final Color WORDS = new Color(0xe6eaee);

    private final SurfacePainter painter;
    private final SurfaceDrawing drawing;
    private final PictureView view = new PictureView();
    private final AtomicBoolean isDirty = new AtomicBoolean(true);
    private final CompletableFuture<Void> closed = new CompletableFuture<>();
    private final ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
        Thread made = new Thread(task, "viewport");
        made.setDaemon(true);
        return made;
    });
    /** The picture that is drawn now; {@code null} for none. */
    private CompletableFuture<Drawn> coming;

    /** Is done when what came last is shown, or never will be. */
    private CompletableFuture<Void> ended = CompletableFuture.completedFuture(null);

    private SurfaceSize comingSize;
    private long comingSince;
    /** {@code null} before the first. */
    private BufferedImage visible;
    /** Drawn over by the next picture; {@code null} for none. */
    private BufferedImage spare;

    private RuntimeException failure;
    private boolean isUnavailable;
    private boolean isClosed;

    /**
     * Creates a surface; its context follows with the first picture.
     *
     * @param contexts makes a context current, such as {@link GlContext#offscreen}
     */
    public ViewportSurface(SurfacePainter painter, Supplier<GlContext> contexts) {
        this.painter = painter;
        drawing = new SurfaceDrawing(painter, contexts);
    }

    /** Shows the picture, one of its pixels for each of the display's. */
    private final class PictureView extends JComponent {
        private static final long serialVersionUID = 1;

        private final Timer look = new Timer(LOOK_MILLIS, tick -> look());

        PictureView() {
            setOpaque(true);
            setFocusable(true);
        }

        private void look() {
            if (coming == null) {
                look.stop();
            }
            repaint();
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            if (EventQueue.isDispatchThread() && !isPaintingForPrint()) {
                beginIfDirty();
            }
            graphics.setColor(Color.BLACK);
            graphics.fillRect(0, 0, getWidth(), getHeight());
            if (visible != null) {
                double scale = SurfaceSize.of(this).pixelsPerPoint();
                ((Graphics2D) graphics)
                        .drawImage(visible, AffineTransform.getScaleInstance(1 / scale, 1 / scale), null);
            }
            int seconds = coming == null ? 0 : (int) ((System.nanoTime() - comingSince) / 1_000_000_000L);
            if (seconds > 0) {
                plate((Graphics2D) graphics, painter.waiting(seconds));
            }
        }

        private void plate(Graphics2D graphics, String words) {
            FontMetrics font = graphics.getFontMetrics(getFont());
            int width = font.stringWidth(words) + 2 * PLATE_POINTS;
            int height = font.getHeight() + PLATE_POINTS;
            int x = (getWidth() - width) / 2;
            int y = getHeight() - height - 2 * PLATE_POINTS;
            graphics.setColor(PLATE);
            graphics.fillRoundRect(x, y, width, height, PLATE_POINTS, PLATE_POINTS);
            graphics.setColor(WORDS);
            graphics.setFont(getFont());
            graphics.drawString(words, x + PLATE_POINTS, y + PLATE_POINTS / 2 + font.getAscent());
        }
    }

    /** Returns the component to add to a window. */
    public Component component() {
        return view;
    }

    /** Sends the user's input to listeners; positions are in points of the picture. */
    public void listen(MouseAdapter mouse, KeyListener keys) {
        view.addMouseListener(mouse);
        view.addMouseMotionListener(mouse);
        view.addMouseWheelListener(mouse);
        view.addKeyListener(keys);
        // Tab and the arrows belong to the viewport, not to the traversal of focus.
        view.setFocusTraversalKeysEnabled(false);
    }

    /** Asks for the keyboard's focus. */
    public void requestFocus() {
        view.requestFocusInWindow();
    }

    /** Returns the present size. */
    public SurfaceSize size() {
        return SurfaceSize.of(view);
    }

    /** Draws soon; several calls before that are one. May be called on every thread. */
    public void repaintSoon() {
        isDirty.set(true);
        view.repaint();
    }

    /** Draws now, waits for it, and returns the picture: for what is kept, never for what is only shown. */
    public BufferedImage picture() {
        settle();
        isDirty.set(true);
        beginIfDirty();
        settle();
        SurfaceSize size = size();
        BufferedImage copy = new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
        if (visible != null) {
            copy.getGraphics().drawImage(visible, 0, 0, null);
        }
        return copy;
    }

    /** Returns a copy of the picture that is shown; empty before the first. */
    public Optional<BufferedImage> visible() {
        return Optional.ofNullable(visible).map(picture -> {
            var copy = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
            picture.copyData(copy.getRaster());
            return copy;
        });
    }

    /** Begins the next picture if something has changed since the last one and none is being drawn. */
    private void beginIfDirty() {
        SurfaceSize size = size();
        boolean isWanted = isDirty.get() || !size.equals(comingSize);
        if (coming != null || isUnavailable || isClosed || !isWanted) {
            return;
        }
        isDirty.set(false);
        Painting next = painter.next(size);
        comingSize = size;
        comingSince = System.nanoTime();
        BufferedImage into = spare;
        spare = null;
        CompletableFuture<Drawn> begun = CompletableFuture.supplyAsync(() -> drawing.draw(next, size, into), thread);
        coming = begun;
        ended = new CompletableFuture<>();
        if (EventQueue.isDispatchThread()) {
            view.look.start();
            begun.whenComplete((drawn, thrown) -> EventQueue.invokeLater(() -> end(begun)));
        }
    }

    /** Waits for the picture that is being drawn. */
    private void settle() {
        if (coming != null) {
            end(coming);
        }
    }

    private void end(CompletableFuture<Drawn> drawn) {
        if (coming != drawn || isClosed) {
            return;
        }
        try {
            Drawn there = drawn.join();
            spare = visible;
            visible = there.picture();
            there.afterwards().run();
        } catch (CompletionException failed) {
            if (failed.getCause() instanceof Error error) {
                throw error;
            }
            failure = (RuntimeException) failed.getCause();
            isUnavailable |= failure instanceof GlUnavailableException;
            painter.failed(String.valueOf(failure.getMessage()));
        } finally {
            coming = null;
            ended.complete(null);
        }
        view.repaint();
    }

    /** Is done when the picture that is being drawn is shown, or the surface is closed; called on Swing's thread. */
    public CompletableFuture<Void> drawing() {
        return ended;
    }

    /** Returns the number of objects of the context, after {@link #close} those that were left; empty before a picture. */
    public Map<GlKind, Integer> liveObjects() {
        if (isClosed) {
            closed.join();
            return drawing.liveObjects();
        }
        return CompletableFuture.supplyAsync(drawing::liveObjects, thread).join();
    }

    /** Returns the last exception by which a picture failed; the user sees only its message. */
    public Optional<RuntimeException> failure() {
        return Optional.ofNullable(failure);
    }

    /** Closes what was made with the context, and the context, after what is being drawn; {@link #closed} tells when. */
    @Override
    public void close() {
        if (isClosed) {
            return;
        }
        isClosed = true;
        view.look.stop();
        ended.complete(null);
        CompletableFuture.runAsync(drawing::close, thread).whenComplete((nothing, thrown) -> {
            if (thrown == null) {
                closed.complete(null);
            } else {
                closed.completeExceptionally(thrown);
            }
        });
        thread.shutdown();
    }

    /** Is done when the context has ended. */
    public CompletableFuture<Void> closed() {
        return closed;
    }
}
