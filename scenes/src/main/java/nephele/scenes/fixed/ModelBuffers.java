package nephele.scenes.fixed;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import nephele.engine.model.Mesh;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import org.lwjgl.BufferUtils;

/** A mesh on the GPU. */
final class ModelBuffers implements AutoCloseable {
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3, Attribute.FLOAT2);

    private final GpuMesh mesh;
    private final int indices;

    ModelBuffers(GlContext gl, String name, Mesh from) {
        ByteBuffer vertices = BufferUtils.createByteBuffer(from.vertexCount() * FORMAT.strideBytes())
                .order(ByteOrder.nativeOrder());
        for (int v = 0; v < from.vertexCount(); v++) {
            put(vertices, from.positions(), 3 * v, 3);
            put(vertices, from.normals(), 3 * v, 3);
            put(vertices, from.textureCoordinates(), 2 * v, 2);
        }
        indices = from.indices().length;
        IntBuffer triangles = BufferUtils.createIntBuffer(indices).put(from.indices());
        mesh = new GpuMesh(gl, name, FORMAT, vertices.flip(), triangles.flip());
    }

    private static void put(ByteBuffer to, float[] from, int first, int count) {
        for (int i = first; i < first + count; i++) {
            to.putFloat(from[i]);
        }
    }

    void draw(int instances) {
        mesh.drawInstanced(0, indices, instances);
    }

    @Override
    public void close() {
        mesh.close();
    }
}
