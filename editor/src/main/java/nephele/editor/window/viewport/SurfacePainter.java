package nephele.editor.window.viewport;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;

/**
 * Decides what a surface shows. The methods of one group are called on the surface's drawing thread, while its context is
 * current, those of the other on the thread of Swing, or without a display on the one that asks for pictures.
 */
public interface SurfacePainter {
    /** Called on the drawing thread when there is a context. */
    void opened(GlContext gl);

    /** Called on the drawing thread before the context ends: everything that was made with it has to be closed now. */
    void closing();

    /** Called on Swing's thread: takes from the present state all that the next picture shows, and returns at once. */
    Painting next(SurfaceSize size);

    /** Called on Swing's thread if drawing failed, or if no context can be had; the surface then keeps its last picture. */
    void failed(String reason);

    /** Called on Swing's thread: returns what to say while a picture is drawn. @param seconds that it has taken so far */
    String waiting(int seconds);

    /** One picture that is to be drawn. */
    @FunctionalInterface
    interface Painting {
        /**
         * Draws over the whole target, whose content before is undefined, on the drawing thread.
         *
         * @return called on Swing's thread once the picture is there
         */
        Runnable draw(RenderTarget target);
    }
}
