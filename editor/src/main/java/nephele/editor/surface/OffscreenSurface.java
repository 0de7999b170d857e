package nephele.editor.surface;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import javax.swing.JComponent;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlKind;
import nephele.engine.render.gl.GlUnavailableException;
import nephele.engine.render.gl.LiveObjects;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/** Draws into a picture offscreen, which a lightweight component shows. It also works without a display. */
public final class OffscreenSurface implements ViewportSurface {
    private final SurfacePainter painter;
    private final Supplier<GlContext> contexts;
    private final PictureView view = new PictureView();
    private final AtomicBoolean isDirty = new AtomicBoolean(true);
    private GlContext gl;
    /** Objects of the present context, after {@link #close} of the last one; {@code null} before the first. */
    private LiveObjects live;

    private RuntimeException failure;
    private RenderTarget target;
    private BufferedImage picture;
    private int[] fromBelow = {};
    private boolean isUnavailable;

    /**
     * Creates a surface; its context follows with the first picture, on the thread that draws it.
     *
     * @param contexts makes a context current, such as {@link GlContext#offscreen}
     */
    public OffscreenSurface(SurfacePainter painter, Supplier<GlContext> contexts) {
        this.painter = painter;
        this.contexts = contexts;
    }

    /** Shows the picture, one of its pixels for each of the display's. */
    private final class PictureView extends JComponent {
        private static final long serialVersionUID = 1;

        PictureView() {
            setOpaque(true);
            setFocusable(true);
            setMinimumSize(new Dimension(1, 1));
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            drawIfDirty();
            if (picture != null) {
                double scale = SurfaceSize.of(this).pixelsPerPoint();
                ((Graphics2D) graphics)
                        .drawImage(picture, AffineTransform.getScaleInstance(1 / scale, 1 / scale), null);
            }
        }
    }

    @Override
    public Component component() {
        return view;
    }

    @Override
    public void repaintSoon() {
        isDirty.set(true);
        view.repaint();
    }

    @Override
    public BufferedImage picture() {
        isDirty.set(true);
        drawIfDirty();
        SurfaceSize size = size();
        BufferedImage copy = new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
        if (picture != null) {
            picture.copyData(copy.getRaster());
        }
        return copy;
    }

    /** Draws if something has changed since the last picture. */
    private void drawIfDirty() {
        SurfaceSize size = size();
        boolean isSameSize = target != null && target.width() == size.width() && target.height() == size.height();
        if (!isDirty.getAndSet(false) && isSameSize || isUnavailable) {
            return;
        }
        try {
            prepare(size);
            painter.paint(target, size);
            read();
        } catch (RuntimeException thrown) {
            failure = thrown;
            isUnavailable |= thrown instanceof GlUnavailableException;
            painter.failed(String.valueOf(thrown.getMessage()));
        }
    }

    private void prepare(SurfaceSize size) {
        if (gl == null) {
            gl = contexts.get();
            live = gl.live();
            painter.opened(gl);
        }
        if (target == null || target.width() != size.width() || target.height() != size.height()) {
            closeTarget();
            target = RenderTarget.picture(gl, "viewport", PixelFormat.RGBA8, size.width(), size.height());
            picture = new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
            fromBelow = new int[size.width() * size.height()];
        }
    }

    private void read() {
        target.readRgb(fromBelow);
        int[] rows = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        int width = target.width();
        for (int y = 0; y < target.height(); y++) {
            System.arraycopy(fromBelow, y * width, rows, (target.height() - 1 - y) * width, width);
        }
    }

    /** Returns the number of objects of the context, after {@link #close} those that were left; empty before a picture. */
    public Map<GlKind, Integer> liveObjects() {
        return live == null ? Map.of() : live.counts();
    }

    /** Returns the last exception by which a picture failed; the user sees only its message. */
    public Optional<RuntimeException> failure() {
        return Optional.ofNullable(failure);
    }

    private void closeTarget() {
        if (target != null) {
            target.close();
            target = null;
        }
    }

    @Override
    public void close() {
        if (gl != null) {
            painter.closing();
            closeTarget();
            gl.close();
            gl = null;
        }
    }
}
