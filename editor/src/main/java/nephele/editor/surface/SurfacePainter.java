package nephele.editor.surface;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;

/** Draws on a surface. All methods are called on the surface's thread while its context is current. */
public interface SurfacePainter {
    /** Called when there is a context, and again with a new one if the window system has taken the last one. */
    void opened(GlContext gl);

    /** Draws over the whole target; its content before is undefined. */
    void paint(RenderTarget target, SurfaceSize size);

    /** Called before the context ends: everything that was made with it has to be closed now. */
    void closing();

    /** Called if drawing failed, or if no context can be had; the surface then keeps its last picture. */
    void failed(String reason);
}
