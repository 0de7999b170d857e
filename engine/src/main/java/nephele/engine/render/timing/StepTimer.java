package nephele.engine.render.timing;

import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;

/** Times the steps of frames. */
public interface StepTimer extends StepListener, AutoCloseable {
    /** Must be called before each timed frame. */
    void frameBegins();

    /** Returns the mean time of one step since the last {@link #reset}; 0 before it was timed. */
    double meanMs(int step);

    /** Discards the measured times. */
    void reset();

    /** Returns the name of the clock, for readers of the figures. */
    String clock();

    @Override
    void close();

    /**
     * Returns a timer that uses queries on hardware, and waits with {@code glFinish} after each step if OpenGL runs in
     * software, where its timer queries are wrong.
     */
    static StepTimer of(GlContext gl, int steps) {
        return gl.limits().software() ? new FinishTimer(gl, steps) : new QueryTimer(gl, steps);
    }
}
