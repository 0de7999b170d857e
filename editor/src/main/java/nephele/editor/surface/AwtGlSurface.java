package nephele.editor.surface;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import org.lwjgl.opengl.awt.AWTGLCanvas;
import org.lwjgl.opengl.awt.GLData;

/** Draws directly on a heavyweight canvas of the window system. */
public final class AwtGlSurface implements ViewportSurface {
    private final SurfacePainter painter;
    private final Consumer<String> whenUnavailable;
    private final GlCanvas canvas;
    private final AtomicBoolean isWaiting = new AtomicBoolean();
    /** {@code null} while the canvas is in no window. */
    private GlContext gl;

    private boolean isUnavailable;

    /**
     * Creates a surface; its context follows when it is first painted.
     *
     * @param whenUnavailable called once with the reason if this system gives no context to a canvas; the surface then
     * shows nothing
     * @throws LinkageError if the library of canvases does not work with this system
     */
    public AwtGlSurface(SurfacePainter painter, Consumer<String> whenUnavailable) {
        this.painter = painter;
        this.whenUnavailable = whenUnavailable;
        canvas = new GlCanvas(format());
    }

    private static GLData format() {
        GLData format = new GLData();
        format.majorVersion = 4;
        format.minorVersion = 1;
        format.profile = GLData.Profile.CORE;
        format.forwardCompatible = true;
        format.samples = 0;
        format.swapInterval = 0;
        return format;
    }

    /** The canvas; its context ends whenever it leaves its window. */
    private final class GlCanvas extends AWTGLCanvas {
        private static final long serialVersionUID = 1;

        /** The size of the last picture; {@code null} before the first. */
        private transient SurfaceSize painted;

        GlCanvas(GLData format) {
            super(format);
            setMinimumSize(new Dimension(1, 1));
            setFocusable(true);
        }

        @Override
        public void initGL() {
            gl = GlContext.ofCurrent();
            painter.opened(gl);
        }

        @Override
        public void paintGL() {
            gl.resume();
            SurfaceSize size = SurfaceSize.of(this);
            painter.paint(RenderTarget.window(gl, size.width(), size.height()), size);
            swapBuffers();
            if (!size.equals(painted)) {
                // Drivers may give the buffers their new size only with the swap: what was drawn then had the old one.
                painted = size;
                repaintSoon();
            }
        }

        @Override
        public void paint(Graphics graphics) {
            draw();
        }

        /** Does not clear the background before: it would flicker. */
        @Override
        public void update(Graphics graphics) {
            draw();
        }

        @Override
        public void removeNotify() {
            end();
            super.removeNotify();
        }

        private void end() {
            if (gl != null) {
                runInContext(() -> {
                    painter.closing();
                    gl.close();
                });
                gl = null;
            }
        }
    }

    private void draw() {
        if (isUnavailable || !canvas.isDisplayable() || canvas.getWidth() == 0 || canvas.getHeight() == 0) {
            return;
        }
        try {
            canvas.render();
        } catch (RuntimeException | LinkageError failure) {
            failed(failure);
        }
    }

    private void failed(Throwable failure) {
        Throwable cause = failure.getCause() == null ? failure : failure.getCause();
        String reason = String.valueOf(cause.getMessage());
        if (gl == null) {
            isUnavailable = true;
            whenUnavailable.accept(reason);
        } else {
            painter.failed(reason);
        }
    }

    @Override
    public Component component() {
        return canvas;
    }

    @Override
    public void repaintSoon() {
        if (!isWaiting.getAndSet(true)) {
            EventQueue.invokeLater(() -> {
                isWaiting.set(false);
                draw();
            });
        }
    }

    /** {@inheritDoc} It is black while the canvas is in no window. */
    @Override
    public BufferedImage picture() {
        draw();
        SurfaceSize size = size();
        BufferedImage[] picture = {new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB)};
        if (gl != null) {
            canvas.runInContext(() -> picture[0] = offscreen(size));
        }
        return picture[0];
    }

    private BufferedImage offscreen(SurfaceSize size) {
        gl.resume();
        try (RenderTarget target =
                RenderTarget.picture(gl, "screenshot", PixelFormat.RGBA8, size.width(), size.height())) {
            painter.paint(target, size);
            return Capture.image(target);
        }
    }

    @Override
    public void close() {
        canvas.end();
        isUnavailable = true;
    }
}
