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
    /** The triangles of a cell whose corners are 0 to 3: lower left and right, upper left and right. */
    private static final int[] RISING = {0, 1, 3, 3, 2, 0};

    private static final int[] FALLING = {0, 1, 2, 1, 3, 2};

    private final int perSheet;
    private final int floats;
    private final int cells;
    private final GpuMesh sheet;
    private final BufferTexture texels;
    private FloatBuffer staging;

    /**
     * @param perSheet squares of an instance
     * @param floats numbers of each square
     * @param cells along a side of each square, each divided into two triangles: one, or an even number of them, whose
     *     triangles are symmetric about the middle, as is then everything that is interpolated
     */
    public SquareSheet(GlContext gl, String name, int perSheet, int floats, int cells) {
        this.perSheet = perSheet;
        this.floats = floats;
        this.cells = cells;
        ByteBuffer corners = MemoryUtil.memAlloc(perSheet * vertices(cells) * FORMAT.strideBytes());
        IntBuffer triangles = MemoryUtil.memAllocInt(perSheet * indices());
        try {
            for (int square = 0; square < perSheet; square++) {
                putCorners(corners);
                putTriangles(square * vertices(cells), triangles);
            }
            sheet = new GpuMesh(gl, name, FORMAT, corners.flip(), triangles.flip());
        } finally {
            MemoryUtil.memFree(corners);
            MemoryUtil.memFree(triangles);
        }
        texels = BufferTexture.changing(gl, name);
        staging = MemoryUtil.memAllocFloat(floats * perSheet);
    }

    /** Returns the number of vertices of a square of so many cells along a side. */
    public static int vertices(int cells) {
        return (cells + 1) * (cells + 1);
    }

    private int indices() {
        return 6 * cells * cells;
    }

    private void putCorners(ByteBuffer to) {
        for (int row = 0; row <= cells; row++) {
            for (int column = 0; column <= cells; column++) {
                to.putFloat(2f * column / cells - 1).putFloat(2f * row / cells - 1);
            }
        }
    }

    private void putTriangles(int first, IntBuffer to) {
        int[] corners = {0, 1, cells + 1, cells + 2};
        for (int row = 0; row < cells; row++) {
            for (int column = 0; column < cells; column++) {
                for (int corner : column < cells / 2 == row < cells / 2 ? RISING : FALLING) {
                    to.put(first + row * (cells + 1) + column + corners[corner]);
                }
            }
        }
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
        sheet.drawInstanced(0, perSheet * indices(), sheets);
    }

    @Override
    public void close() {
        sheet.close();
        texels.close();
        MemoryUtil.memFree(staging);
    }
}
