package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** Measures GPU time between start and stop; meaningless on CPU rasterisers ({@link GpuLimits#software}). */
public final class GpuTimer implements GlObject {
    private final GlHandle query;

    public GpuTimer(GlContext gl, String name) {
        query = new GlHandle(gl, GlKind.QUERY, name, glGenQueries(), id -> glDeleteQueries(id));
    }

    public void start() {
        glBeginQuery(GL_TIME_ELAPSED, query.id());
    }

    public void stop() {
        glEndQuery(GL_TIME_ELAPSED);
    }

    /** Returns true if {@link #nanoseconds} would not wait. */
    public boolean isDone() {
        return glGetQueryObjecti(query.id(), GL_QUERY_RESULT_AVAILABLE) == GL_TRUE;
    }

    /** Waits for the result of the last start and stop, and returns it. */
    public long nanoseconds() {
        return glGetQueryObjecti64(query.id(), GL_QUERY_RESULT);
    }

    @Override
    public void close() {
        query.close();
    }
}
