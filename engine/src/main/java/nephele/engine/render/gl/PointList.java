package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** Points of one pixel without buffers; the vertex shader computes them from {@code gl_VertexID}. */
public final class PointList implements GlObject {
    private final GlContext gl;
    private final GlHandle vertexArray;
    private final int count;

    public PointList(GlContext gl, String name, int count) {
        this.gl = gl;
        this.count = count;
        vertexArray = new GlHandle(gl, GlKind.VERTEX_ARRAY, name, glGenVertexArrays(), id -> glDeleteVertexArrays(id));
    }

    /** Draws with the current program. */
    public void draw() {
        gl.bindings().vertexArray(vertexArray.id());
        if (gl.state().listener() != null) {
            gl.state().listener().drawnPoints(count);
        }
        glDrawArrays(GL_POINTS, 0, count);
        gl.state().drawn(1, 0);
    }

    @Override
    public void close() {
        vertexArray.close();
    }
}
