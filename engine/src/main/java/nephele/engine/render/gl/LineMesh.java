package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** Lines on the GPU, a pixel wide. */
public final class LineMesh implements GlObject {
    private final GlContext gl;
    private final GlHandle vertexArray;
    private final GlHandle vertices;
    private final int count;

    /**
     * Creates lines.
     *
     * @param format of floats only
     * @param values two vertices for each line
     */
    public LineMesh(GlContext gl, String name, VertexFormat format, float[] values) {
        this.gl = gl;
        count = 4 * values.length / format.strideBytes();
        vertexArray = new GlHandle(gl, GlKind.VERTEX_ARRAY, name, glGenVertexArrays(), id -> glDeleteVertexArrays(id));
        vertices = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        gl.bindings().vertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        glBufferData(GL_ARRAY_BUFFER, values, GL_STATIC_DRAW);
        format.describe();
    }

    public void draw() {
        gl.bindings().vertexArray(vertexArray.id());
        if (gl.state().listener() != null) {
            gl.state().listener().drawnLines(count);
        }
        glDrawArrays(GL_LINES, 0, count);
        gl.state().drawn(1, 0);
    }

    @Override
    public void close() {
        vertexArray.close();
        vertices.close();
    }
}
