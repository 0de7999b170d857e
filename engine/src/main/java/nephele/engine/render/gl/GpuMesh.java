package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import org.lwjgl.system.MemoryUtil;

/** Vertices and 32-bit triangle indices on the GPU. */
public final class GpuMesh implements GlObject {
    private static final float[] SQUARE = {-1, -1, 1, -1, 1, 1, -1, 1};
    private static final int[] TRIANGLES = {0, 1, 2, 2, 3, 0};
    /** Indices of one of {@link #squares}. */
    public static final int SQUARE_INDICES = TRIANGLES.length;

    private final GlContext gl;
    private final GlHandle vertexArray;
    private final GlHandle vertices;
    private final GlHandle indices;

    /**
     * Creates a mesh.
     *
     * @param vertexBytes direct, in the layout of {@code format}
     * @param triangles direct
     */
    public GpuMesh(GlContext gl, String name, VertexFormat format, ByteBuffer vertexBytes, IntBuffer triangles) {
        this.gl = gl;
        vertexArray = new GlHandle(gl, GlKind.VERTEX_ARRAY, name, glGenVertexArrays(), id -> glDeleteVertexArrays(id));
        vertices = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        indices = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        gl.bindings().vertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        glBufferData(GL_ARRAY_BUFFER, vertexBytes, GL_STATIC_DRAW);
        format.describe();
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, triangles, GL_STATIC_DRAW);
    }

    /** Creates squares from −1 to 1 of two coordinates each. */
    public static GpuMesh squares(GlContext gl, String name, int count) {
        ByteBuffer corners = MemoryUtil.memAlloc(count * Float.BYTES * SQUARE.length);
        IntBuffer triangles = MemoryUtil.memAllocInt(count * SQUARE_INDICES);
        try {
            for (int square = 0; square < count; square++) {
                for (float coordinate : SQUARE) {
                    corners.putFloat(coordinate);
                }
                for (int corner : TRIANGLES) {
                    triangles.put(4 * square + corner);
                }
            }
            return new GpuMesh(
                    gl, name, VertexFormat.of(VertexFormat.Attribute.FLOAT2), corners.flip(), triangles.flip());
        } finally {
            MemoryUtil.memFree(corners);
            MemoryUtil.memFree(triangles);
        }
    }

    /** Replaces a part of the vertices, from a byte offset on. */
    public void replaceVertices(long firstByte, ByteBuffer vertexBytes) {
        glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
        glBufferSubData(GL_ARRAY_BUFFER, firstByte, vertexBytes);
    }

    /** Draws {@code count} indices from {@code first} on. */
    public void draw(int first, int count) {
        gl.bindings().vertexArray(vertexArray.id());
        if (gl.state().listener() != null) {
            gl.state().listener().drawn(new int[] {first}, new int[] {count});
        }
        glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, 4L * first);
        gl.state().drawn(1, count / 3);
    }

    /** Draws {@code instances} instances of {@code count} indices from {@code first} on. */
    public void drawInstanced(int first, int count, int instances) {
        gl.bindings().vertexArray(vertexArray.id());
        if (gl.state().listener() != null) {
            gl.state().listener().drawnInstanced(first, count, instances);
        }
        glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, 4L * first, instances);
        gl.state().drawn(1, (long) instances * count / 3);
    }

    /** Draws every range with one call. */
    public void draw(IndexRanges ranges) {
        if (ranges.size() > 0) {
            gl.bindings().vertexArray(vertexArray.id());
            if (gl.state().listener() != null) {
                gl.state().listener().drawn(ranges.firsts(), ranges.counts());
            }
            ranges.multiDraw();
            gl.state().drawn(1, ranges.indexCount() / 3);
        }
    }

    @Override
    public void close() {
        vertexArray.close();
        vertices.close();
        indices.close();
    }
}
