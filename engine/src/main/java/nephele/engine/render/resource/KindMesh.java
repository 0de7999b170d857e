package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.Map;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.impostor.KindShape;
import nephele.engine.scene.impostor.KindSky;
import org.lwjgl.system.MemoryUtil;

/** The mesh of a kind; shader locations 0 position from the foot, 1 normal and sky's share, 2 texture coordinates. */
public final class KindMesh implements GlObject {
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2);
    private static final int ONE = 32767;

    private final Surface surface;
    private final int corners;
    /** {@code null} without triangles. */
    private final GpuMesh mesh;

    /** What is stored once for equal corners. */
    private record Vertex(int number, Vec3 normal) {}

    KindMesh(GlContext gl, KindShape shape, KindSky sky, Surface surface) {
        this.surface = surface;
        WorldTriangles triangles = shape.triangles();
        corners = 3 * triangles.count();
        if (corners == 0) {
            mesh = null;
            return;
        }
        ByteBuffer vertices = MemoryUtil.memAlloc(corners * FORMAT.strideBytes());
        IntBuffer indices = MemoryUtil.memAllocInt(corners);
        try {
            Map<Vertex, Integer> known = new HashMap<>();
            for (int i = 0; i < corners; i++) {
                Vec3 normal = triangles.normal(i / 3, i % 3);
                Vertex vertex = new Vertex(triangles.vertices()[i], normal);
                Integer number = known.get(vertex);
                if (number == null) {
                    number = known.size();
                    known.put(vertex, number);
                    put(triangles, i, normal, sky.ofCorner()[i], vertices);
                }
                indices.put(number);
            }
            mesh = new GpuMesh(gl, "plant", FORMAT, vertices.flip(), indices.flip());
        } finally {
            MemoryUtil.memFree(vertices);
            MemoryUtil.memFree(indices);
        }
    }

    private static void put(WorldTriangles triangles, int corner, Vec3 normal, float sky, ByteBuffer to) {
        Vec3 p = triangles.corner(corner / 3, corner % 3);
        to.putFloat((float) p.x()).putFloat((float) p.y()).putFloat((float) p.z());
        to.putShort((short) Math.round(ONE * normal.x()));
        to.putShort((short) Math.round(ONE * normal.y()));
        to.putShort((short) Math.round(ONE * normal.z()));
        to.putShort((short) Math.round(ONE * sky));
        to.putFloat((float) triangles.s(corner / 3, corner % 3)).putFloat((float) triangles.t(corner / 3, corner % 3));
    }

    public Surface surface() {
        return surface;
    }

    public int triangles() {
        return corners / 3;
    }

    /** Draws instances with the current program. */
    void draw(int instances) {
        if (mesh != null && instances > 0) {
            mesh.drawInstanced(0, corners, instances);
        }
    }

    @Override
    public void close() {
        if (mesh != null) {
            mesh.close();
        }
    }
}
