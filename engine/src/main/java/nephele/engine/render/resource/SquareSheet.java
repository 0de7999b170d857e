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
 * Squares that are drawn with one call, each from numbers in a texture. An instance is a sheet of many squares: software
 * renderers take as long for an instance as for many vertices.
 */
public final class SquareSheet implements GlObject {
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT2);
    private static final float[] CORNERS = {-1, -1, 1, -1, 1, 1, -1, 1};
    private static final int[] TRIANGLES = {0, 1, 2, 2, 3, 0};

    private final int perSheet;
    private final int floats;
    private final GpuMesh sheet;
    private final BufferTexture texels;
    private FloatBuffer staging;

    /**
     * @param perSheet squares of an instance
     * @param floats numbers of each square
     */
    public SquareSheet(GlContext gl, String name, int perSheet, int floats) {
        this.perSheet = perSheet;
        this.floats = floats;
        ByteBuffer corners = MemoryUtil.memAlloc(perSheet * 4 * FORMAT.strideBytes());
        IntBuffer triangles = MemoryUtil.memAllocInt(perSheet * TRIANGLES.length);
        try {
            for (int quad = 0; quad < perSheet; quad++) {
                for (float corner : CORNERS) {
                    corners.putFloat(corner);
                }
                for (int corner : TRIANGLES) {
                    triangles.put(4 * quad + corner);
                }
            }
            sheet = new GpuMesh(gl, name, FORMAT, corners.flip(), triangles.flip());
        } finally {
            MemoryUtil.memFree(corners);
            MemoryUtil.memFree(triangles);
        }
        texels = BufferTexture.changing(gl, name);
        staging = MemoryUtil.memAllocFloat(floats * perSheet);
    }

    /** Returns where the numbers of so many squares go; those of an earlier list are kept. */
    public FloatBuffer staging(int squares) {
        int needed = floats * (squares + perSheet);
        if (staging.capacity() < needed) {
            staging = MemoryUtil.memRealloc(staging, needed + needed / 2);
        }
        return staging;
    }

    /**
     * Draws the list with the current program.
     *
     * @param count squares whose numbers are in {@link #staging}
     * @param filler each number of the squares that are left in the last sheet
     */
    public void draw(int count, float filler, TextureUnit unit) {
        int sheets = (count + perSheet - 1) / perSheet;
        int all = sheets * perSheet * floats;
        for (int i = count * floats; i < all; i++) {
            staging.put(i, filler);
        }
        staging.position(0).limit(all);
        texels.upload(staging);
        staging.clear();
        texels.bind(unit);
        sheet.drawInstanced(0, perSheet * TRIANGLES.length, sheets);
    }

    @Override
    public void close() {
        sheet.close();
        texels.close();
        MemoryUtil.memFree(staging);
    }
}
