package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/** Three vertices without buffers that cover the viewport; the vertex shader computes them from {@code gl_VertexID}. */
public final class FullScreenTriangle implements GlObject {
    private final GlContext gl;
    private final GlHandle vertexArray;

    /**
     * Creates the triangle.
     *
     * @param name its name in messages
     */
    public FullScreenTriangle(GlContext gl, String name) {
        this.gl = gl;
        vertexArray = new GlHandle(gl, GlKind.VERTEX_ARRAY, name, glGenVertexArrays(), id -> glDeleteVertexArrays(id));
    }

    /** Draws with the current program, over the whole viewport. */
    public void draw() {
        gl.bindings().vertexArray(vertexArray.id());
        if (gl.state().listener() != null) {
            gl.state().listener().drawnFullScreen();
        }
        glDrawArrays(GL_TRIANGLES, 0, 3);
        gl.state().drawn(1, 1);
    }

    @Override
    public void close() {
        vertexArray.close();
    }
}
