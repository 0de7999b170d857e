package nephele.engine.render.resource;

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
 * The images of billboards that are drawn, in their order. An instance is a sheet of many squares: software renderers
 * take as long for an instance as for many vertices.
 */
public final class BillboardList implements GlObject {
    /** A multiple of the four images that a texel names. */
    public static final int PER_SHEET = 256;

    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT2);
    private static final float[] CORNERS = {-1, -1, 1, -1, 1, 1, -1, 1};
    private static final int[] TRIANGLES = {0, 1, 2, 2, 3, 0};

    private final GpuMesh sheet;
    private final BufferTexture texels;
    private FloatBuffer staging = MemoryUtil.memAllocFloat(PER_SHEET);
    private int count;

    public BillboardList(GlContext gl) {
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
            sheet = new GpuMesh(gl, "billboards", FORMAT, corners.flip(), triangles.flip());
        } finally {
            MemoryUtil.memFree(corners);
            MemoryUtil.memFree(triangles);
        }
        texels = BufferTexture.changing(gl, "billboard order");
    }

    /** Begins a list. */
    public void begin() {
        count = 0;
        staging.clear();
    }

    /** Adds an image by its number in {@link BillboardQuads}. */
    public void add(int image) {
        if (count + PER_SHEET >= staging.capacity()) {
            staging = MemoryUtil.memRealloc(staging, 2 * staging.capacity() + PER_SHEET);
        }
        staging.put(count++, image);
    }

    public int count() {
        return count;
    }

    /** Draws the list with the current program. */
    public void draw() {
        if (count == 0) {
            return;
        }
        int sheets = (count + PER_SHEET - 1) / PER_SHEET;
        for (int i = count; i < sheets * PER_SHEET; i++) {
            staging.put(i, -1);
        }
        staging.limit(sheets * PER_SHEET);
        texels.upload(staging);
        texels.bind(TextureUnit.BILLBOARD_ORDER);
        sheet.drawInstanced(0, PER_SHEET * TRIANGLES.length, sheets);
    }

    @Override
    public void close() {
        sheet.close();
        texels.close();
        MemoryUtil.memFree(staging);
    }
}
