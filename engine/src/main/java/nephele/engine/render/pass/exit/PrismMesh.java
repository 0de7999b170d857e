package nephele.engine.render.pass.exit;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import org.lwjgl.system.MemoryUtil;

/** A closed upright prism around the unit cylinder, y from 0 to 1; its triangles face inwards. */
final class PrismMesh implements GlObject {
    private static final int SIDES = 24;
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3);

    private final GpuMesh mesh;
    private final int indexCount;

    PrismMesh(GlContext gl) {
        indexCount = 6 * SIDES + 2 * 3 * (SIDES - 2);
        ByteBuffer bytes = MemoryUtil.memAlloc(2 * SIDES * FORMAT.strideBytes()).order(ByteOrder.nativeOrder());
        IntBuffer indices = MemoryUtil.memAllocInt(indexCount);
        try {
            corners(bytes);
            triangles(indices);
            mesh = new GpuMesh(gl, "exit", FORMAT, bytes.flip(), indices.flip());
        } finally {
            MemoryUtil.memFree(bytes);
            MemoryUtil.memFree(indices);
        }
    }

    /** Writes corner 2 i at the base and 2 i + 1 above it; the sides touch the unit circle. */
    private static void corners(ByteBuffer bytes) {
        double radius = 1 / Math.cos(Math.PI / SIDES);
        for (int i = 0; i < SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            float x = (float) (radius * Math.cos(angle));
            float z = (float) (radius * Math.sin(angle));
            bytes.putFloat(x).putFloat(0).putFloat(z);
            bytes.putFloat(x).putFloat(1).putFloat(z);
        }
    }

    private static void triangles(IntBuffer indices) {
        for (int i = 0; i < SIDES; i++) {
            int here = 2 * i;
            int next = 2 * ((i + 1) % SIDES);
            indices.put(here).put(next).put(here + 1);
            indices.put(next).put(next + 1).put(here + 1);
        }
        for (int i = 2; i < SIDES; i++) {
            indices.put(0).put(2 * i).put(2 * i - 2);
            indices.put(1).put(2 * i - 1).put(2 * i + 1);
        }
    }

    void draw() {
        mesh.draw(0, indexCount);
    }

    @Override
    public void close() {
        mesh.close();
    }
}
