package nephele.editor.surface;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/** Fills its surface with a colour, and notes what happens to it. */
final class FillPainter implements SurfacePainter {
    final List<String> events = new ArrayList<>();
    float red = 1;
    RuntimeException failure;
    private GlContext gl;
    private RenderTarget owned;

    @Override
    public void opened(GlContext context) {
        gl = context;
        owned = RenderTarget.picture(gl, "painter's", PixelFormat.RGBA8, 4, 4);
        events.add("opened");
    }

    @Override
    public void paint(RenderTarget target, SurfaceSize size) {
        events.add("painted " + size.width() + " x " + size.height());
        if (failure != null) {
            throw failure;
        }
        target.clear(red, 0.2f, 0);
        // The upper half is blue.
        gl.state().scissor(0, target.height() / 2, target.width(), target.height());
        target.clearWithinScissor(0, 0, 1);
        gl.state().noScissor();
    }

    @Override
    public void closing() {
        owned.close();
        // The surface's own target may still be there.
        events.add("closing");
    }

    @Override
    public void failed(String reason) {
        events.add("failed: " + reason);
    }

    /** Returns the number of OpenGL objects that are not closed. */
    int live() {
        return gl.live().counts().values().stream().mapToInt(Integer::intValue).sum();
    }
}
