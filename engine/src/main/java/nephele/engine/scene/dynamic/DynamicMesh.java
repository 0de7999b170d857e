package nephele.engine.scene.dynamic;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.Arrays;
import nephele.engine.scene.SolidGeometry.Triangles;

/**
 * Collects the shapes of one level's dynamic objects in one vertex and one index buffer. A vertex has {@link #VERTEX_BYTES}
 * bytes: position, three floats in the part's own frame; outward normal, three 16-bit integers to be normalised,
 * followed by {@code part · PARTS_STRIDE + material}; texture coordinates, two floats.
 */
public final class DynamicMesh {
    public static final int VERTEX_BYTES = 28;

    /** The factor on the part's number in a vertex' fourth integer; a dynamic object has at most as many materials. */
    public static final int PARTS_STRIDE = 64;

    /** The range of a shape's triangles in the index buffer. */
    public record Range(int first, int count) {}

    private ByteBuffer vertices = fresh(1 << 14);
    private int[] indices = new int[1 << 10];
    private int indexCount;
    private int tag;

    private static ByteBuffer fresh(int bytes) {
        return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
    }

    /** Sets the part and the material of the following vertices. */
    DynamicMesh tag(int part, int material) {
        tag = part * PARTS_STRIDE + material;
        return this;
    }

    /**
     * Adds a vertex.
     *
     * @return the vertex' number
     */
    int vertex(double[] position, double[] unitNormal, double u, double v) {
        if (vertices.remaining() < VERTEX_BYTES) {
            vertices = fresh(2 * vertices.capacity()).put(vertices.flip());
        }
        for (int axis = 0; axis < 3; axis++) {
            vertices.putFloat((float) position[axis]);
        }
        for (int axis = 0; axis < 3; axis++) {
            vertices.putShort((short) Math.round(unitNormal[axis] * Short.MAX_VALUE));
        }
        vertices.putShort((short) tag);
        vertices.putFloat((float) u).putFloat((float) v);
        return vertices.position() / VERTEX_BYTES - 1;
    }

    void triangle(int a, int b, int c) {
        if (indexCount + 3 > indices.length) {
            indices = Arrays.copyOf(indices, 2 * indices.length);
        }
        indices[indexCount++] = a;
        indices[indexCount++] = b;
        indices[indexCount++] = c;
    }

    int indexCount() {
        return indexCount;
    }

    /** Returns the range of indices added since {@code first}. */
    Range since(int first) {
        return new Range(first, indexCount - first);
    }

    /** Returns the vertices and the triangles, counter-clockwise seen from outside. */
    Triangles finished() {
        IntBuffer direct = fresh(4 * indexCount).asIntBuffer();
        direct.put(indices, 0, indexCount).flip();
        return new Triangles(vertices.flip(), direct);
    }
}
