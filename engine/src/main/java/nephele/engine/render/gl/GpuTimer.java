package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** Time the GPU spent between start and stop; on CPU rasterisers it means nothing ({@link GpuLimits#software}). */
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

    /** Waits for the answer of the last start and stop. */
    public long nanoseconds() {
        return glGetQueryObjecti64(query.id(), GL_QUERY_RESULT);
    }

    @Override
    public void close() {
        query.close();
    }
}
