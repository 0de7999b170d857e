package nephele.lab.bench;

import nephele.engine.render.gl.GlContext;

/** A round of frames that can be drawn repeatedly, by the engine, by the bare twin or for calibration. */
public interface Drawing extends AutoCloseable {
    /** Returns the number of frames in a round. */
    int roundLength();

    /** Submits one frame of the round. */
    void draw(int frame);

    /** Returns the draw calls of the last frame. */
    default long draws(GlContext gl) {
        return gl.state().draws();
    }

    /** Returns the triangles of the last frame. */
    default long triangles(GlContext gl) {
        return gl.state().triangles();
    }

    /**
     * Returns a drawing of the same frames by plain OpenGL calls, with the same counts. This drawing must remain open
     * as long as it is used.
     */
    default Drawing bareTwin(GlContext gl) {
        return TwinDrawing.of(this, gl);
    }

    @Override
    void close();
}
