package nephele.editor.window.viewport;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Map;
import java.util.function.Supplier;
import nephele.editor.window.viewport.SurfacePainter.Painting;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlKind;
import nephele.engine.render.gl.LiveObjects;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/** The part of a surface that has an OpenGL context; used by its drawing thread alone. */
final class SurfaceDrawing {
    private final SurfacePainter painter;
    private final Supplier<GlContext> contexts;
    private GlContext gl;
    /** Objects of the present context, after {@link #close} of the last one; {@code null} before the first. */
    private LiveObjects live;

    private RenderTarget target;
    private int[] fromBelow = {};

    /** A picture that was drawn. @param afterwards called on Swing's thread */
    record Drawn(BufferedImage picture, Runnable afterwards) {}

    SurfaceDrawing(SurfacePainter painter, Supplier<GlContext> contexts) {
        this.painter = painter;
        this.contexts = contexts;
    }

    /** Draws into a picture, or into a new one if that is {@code null} or of another size. */
    Drawn draw(Painting painting, SurfaceSize size, BufferedImage spare) {
        if (gl == null) {
            gl = contexts.get();
            live = gl.live();
            painter.opened(gl);
        }
        if (target == null || target.width() != size.width() || target.height() != size.height()) {
            closeTarget();
            target = RenderTarget.picture(gl, "viewport", PixelFormat.RGBA8, size.width(), size.height());
            fromBelow = new int[size.width() * size.height()];
        }
        Runnable afterwards = painting.draw(target);
        boolean fits = spare != null && spare.getWidth() == size.width() && spare.getHeight() == size.height();
        BufferedImage into = fits ? spare : new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
        read(((DataBufferInt) into.getRaster().getDataBuffer()).getData());
        return new Drawn(into, afterwards);
    }

    private void read(int[] rows) {
        target.readRgb(fromBelow);
        int width = target.width();
        for (int y = 0; y < target.height(); y++) {
            System.arraycopy(fromBelow, y * width, rows, (target.height() - 1 - y) * width, width);
        }
    }

    Map<GlKind, Integer> liveObjects() {
        return live == null ? Map.of() : live.counts();
    }

    private void closeTarget() {
        if (target != null) {
            target.close();
            target = null;
        }
    }

    void close() {
        if (gl != null) {
            painter.closing();
            closeTarget();
            gl.close();
            gl = null;
        }
    }
}
