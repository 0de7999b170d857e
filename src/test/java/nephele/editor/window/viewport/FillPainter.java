package nephele.editor.window.viewport;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/** Fills its surface with a colour, and notes what happens to it and on which kind of thread. */
final class FillPainter implements SurfacePainter {
    final List<String> events = Collections.synchronizedList(new ArrayList<>());
    /** Called on the drawing thread before each picture. */
    Runnable before = () -> {};

    float red = 1;
    RuntimeException failure;
    private final Thread user = Thread.currentThread();
    private GlContext gl;
    private RenderTarget owned;

    private void note(String event) {
        events.add((Thread.currentThread() == user ? "" : "beside: ") + event);
    }

    @Override
    public void opened(GlContext context) {
        gl = context;
        owned = RenderTarget.picture(gl, "painter's", PixelFormat.RGBA8, 4, 4);
        note("opened");
    }

    @Override
    public Painting next(SurfaceSize size) {
        note("next " + size.width() + " x " + size.height());
        return this::paint;
    }

    private Runnable paint(RenderTarget target) {
        before.run();
        if (failure != null) {
            throw failure;
        }
        target.clear(red, 0.2f, 0);
        // The upper half is blue.
        gl.state().scissor(0, target.height() / 2, target.width(), target.height());
        target.clearWithinScissor(0, 0, 1, 1);
        gl.state().noScissor();
        note("painted");
        return () -> note("told");
    }

    @Override
    public void closing() {
        owned.close();
        note("closing");
    }

    @Override
    public void failed(String reason) {
        note("failed: " + reason);
    }

    @Override
    public String waiting(int seconds) {
        return "waiting";
    }
}
