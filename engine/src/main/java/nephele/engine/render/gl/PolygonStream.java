package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.FloatBuffer;
import java.util.Arrays;
import org.lwjgl.system.MemoryUtil;

/** Triangles whose vertices change every frame: uploaded as a whole, then drawn in runs. */
public final class PolygonStream implements GlObject {
    private final GlContext gl;
    private final GlHandle vertexArray;
    private final GlHandle vertices;
    private FloatBuffer copy = MemoryUtil.memAllocFloat(1024);

    /** @param format of floats only */
    public PolygonStream(GlContext gl, String name, VertexFormat format) {
        this.gl = gl;
        vertexArray = new GlHandle(gl, GlKind.VERTEX_ARRAY, name, glGenVertexArrays(), id -> glDeleteVertexArrays(id));
        vertices = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        gl.bindings().vertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        format.describe();
    }

    /** Replaces all vertices by the first {@code floats} numbers. */
    public void upload(float[] values, int floats) {
        if (copy.capacity() < floats) {
            MemoryUtil.memFree(copy);
            copy = MemoryUtil.memAllocFloat(2 * floats);
        }
        copy.clear().put(values, 0, floats).flip();
        gl.bindings().vertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        glBufferData(GL_ARRAY_BUFFER, copy, GL_STREAM_DRAW);
        if (gl.state().listener() != null) {
            gl.state().listener().uploaded(vertices.id(), Arrays.copyOf(values, floats));
        }
    }

    /** Draws {@code count} vertices from {@code first} on, three for each triangle. */
    public void draw(int first, int count) {
        gl.bindings().vertexArray(vertexArray.id());
        if (gl.state().listener() != null) {
            gl.state().listener().drawnUnindexed(first, count);
        }
        glDrawArrays(GL_TRIANGLES, first, count);
        gl.state().drawn(1, count / 3);
    }

    @Override
    public void close() {
        vertexArray.close();
        vertices.close();
        MemoryUtil.memFree(copy);
    }
}
