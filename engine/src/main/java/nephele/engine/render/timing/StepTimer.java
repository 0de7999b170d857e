package nephele.engine.render.timing;

import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;

/** Times the steps of frames. */
public interface StepTimer extends StepListener, AutoCloseable {
    /** Call before each frame that is timed. */
    void frameBegins();

    /** The mean time of one step since the last {@link #reset}; 0 before it was timed. */
    double meanMs(int step);

    void reset();

    /** Which clock it is, for whoever reads the figures. */
    String clock();

    @Override
    void close();

    /**
     * Timer queries on hardware; waiting with {@code glFinish} after each step where OpenGL runs in software, because
     * its timer queries are wrong there.
     */
    static StepTimer of(GlContext gl, int steps) {
        return gl.limits().software() ? new FinishTimer(gl, steps) : new QueryTimer(gl, steps);
    }
}
