package nephele.engine.render.pass.particle;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/**
 * The squares of a view's particles, drawn with one call. An instance is a sheet of many squares: software renderers
 * take as long for an instance as for many vertices.
 */
final class ParticleQuads implements GlObject {
    static final int PER_SHEET = 512;
    /** Three texels for each particle, see {@code particle.vert}. */
    static final int FLOATS = 12;

    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT2);
    private static final float[] CORNERS = {-1, -1, 1, -1, 1, 1, -1, 1};
    private static final int[] TRIANGLES = {0, 1, 2, 2, 3, 0};

    private final GpuMesh sheet;
    private final BufferTexture texels;
    private FloatBuffer staging = MemoryUtil.memAllocFloat(FLOATS * PER_SHEET);
    private int count;

    ParticleQuads(GlContext gl) {
        ByteBuffer corners = MemoryUtil.memAlloc(PER_SHEET * 4 * FORMAT.strideBytes());
        IntBuffer triangles = MemoryUtil.memAllocInt(PER_SHEET * TRIANGLES.length);
        try {
            for (int quad = 0; quad < PER_SHEET; quad++) {
                for (float corner : CORNERS) {
                    corners.putFloat(corner);
                }
                for (int corner : TRIANGLES) {
                    triangles.put(4 * quad + corner);
                }
            }
            sheet = new GpuMesh(gl, "particles", FORMAT, corners.flip(), triangles.flip());
        } finally {
            MemoryUtil.memFree(corners);
            MemoryUtil.memFree(triangles);
        }
        texels = BufferTexture.changing(gl, "particles");
    }

    /**
     * Begins the list of a view.
     *
     * @return where the {@link #FLOATS} numbers of each particle go, the farthest first
     */
    FloatBuffer begin(int particles) {
        count = particles;
        int floats = FLOATS * (particles + PER_SHEET);
        if (staging.capacity() < floats) {
            MemoryUtil.memFree(staging);
            staging = MemoryUtil.memAllocFloat(floats + floats / 2);
        }
        return staging.clear();
    }

    /** Draws the list with the current program, which reads the texels from unit {@code DYNAMIC_INSTANCES}. */
    void draw() {
        int sheets = (count + PER_SHEET - 1) / PER_SHEET;
        int floats = sheets * PER_SHEET * FLOATS;
        for (int i = count * FLOATS; i < floats; i++) {
            staging.put(i, 0);
        }
        texels.upload(staging.limit(floats));
        texels.bind(TextureUnit.DYNAMIC_INSTANCES);
        sheet.drawInstanced(0, PER_SHEET * TRIANGLES.length, sheets);
    }

    @Override
    public void close() {
        sheet.close();
        texels.close();
        MemoryUtil.memFree(staging);
    }
}
