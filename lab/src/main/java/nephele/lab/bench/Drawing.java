package nephele.lab.bench;

import nephele.engine.render.gl.GlContext;

/** Frames of a round that can be drawn again and again: the engine's, the bare twin's or the calibration's. */
public interface Drawing extends AutoCloseable {
    /** How many frames a round has. */
    int roundLength();

    /** Submits one frame of the round. */
    void draw(int frame);

    /** Draw calls of the last frame. */
    default long draws(GlContext gl) {
        return gl.state().draws();
    }

    /** Triangles of the last frame. */
    default long triangles(GlContext gl) {
        return gl.state().triangles();
    }

    /** The same frames by plain OpenGL calls, with the same counts; this drawing has to stay open as long. */
    default Drawing bareTwin(GlContext gl) {
        return TwinDrawing.of(this, gl);
    }

    @Override
    void close();
}
