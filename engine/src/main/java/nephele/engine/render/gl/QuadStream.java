package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import org.lwjgl.system.MemoryUtil;

/** Quads that change occasionally: four vertices of float4s each, replaced as a whole. */
public final class QuadStream implements GlObject {
    private static final int[] TWO_TRIANGLES = {0, 1, 2, 2, 3, 0};

    private final GlContext gl;
    private final GlHandle vertexArray;
    private final GlHandle vertices;
    private final GlHandle indices;
    private int quads;
    private int indexedQuads;

    public QuadStream(GlContext gl, String name, VertexFormat format) {
        this.gl = gl;
        vertexArray = new GlHandle(gl, GlKind.VERTEX_ARRAY, name, glGenVertexArrays(), id -> glDeleteVertexArrays(id));
        vertices = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        indices = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        gl.bindings().vertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        format.describe();
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    }

    /** Replaces all vertices by the first {@code floats} numbers. */
    public void upload(float[] values, int floats, int quadCount) {
        quads = quadCount;
        gl.bindings().vertexArray(vertexArray.id());
        FloatBuffer copy = MemoryUtil.memAllocFloat(floats);
        copy.put(values, 0, floats).flip();
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        glBufferData(GL_ARRAY_BUFFER, copy, GL_STREAM_DRAW);
        MemoryUtil.memFree(copy);
        if (quadCount > indexedQuads) {
            index(Math.max(quadCount, 2 * indexedQuads));
        }
    }

    private void index(int count) {
        IntBuffer triangles = MemoryUtil.memAllocInt(count * TWO_TRIANGLES.length);
        for (int quad = 0; quad < count; quad++) {
            for (int corner : TWO_TRIANGLES) {
                triangles.put(4 * quad + corner);
            }
        }
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, triangles.flip(), GL_STATIC_DRAW);
        MemoryUtil.memFree(triangles);
        indexedQuads = count;
    }

    public void draw() {
        draw(0, quads);
    }

    /** Draws some of the quads. */
    public void draw(int first, int count) {
        gl.bindings().vertexArray(vertexArray.id());
        glDrawElements(
                GL_TRIANGLES,
                TWO_TRIANGLES.length * count,
                GL_UNSIGNED_INT,
                (long) TWO_TRIANGLES.length * Integer.BYTES * first);
        gl.state().drawn(1, 2L * count);
    }

    @Override
    public void close() {
        vertexArray.close();
        vertices.close();
        indices.close();
    }
}
