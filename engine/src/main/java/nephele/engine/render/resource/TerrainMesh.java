package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import nephele.engine.math.Frustum;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.math.heightfield.SampleRange;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/**
 * A height field on the GPU: its heights as floats, the very numbers of collision and rays; its slopes, from which the
 * smooth normals follow; and a mesh of {@link #CHUNK_CELLS}² cells that is drawn once for each chunk. Shader location 0 is
 * the column and row within the chunk. {@code terrain-position.glsl} places a vertex.
 */
public final class TerrainMesh implements GlObject {
    public static final SharedResource<List<TerrainMesh>> RESOURCE = SharedResource.of("terrains", TerrainMesh::of);

    /** Cells along a side of a chunk. */
    public static final int CHUNK_CELLS = 64;

    /** Rows of texels that are uploaded at once. */
    private static final int UPLOAD_ROWS = 64;

    private final HeightField field;
    private final Texture heights;
    private final Texture slopes;
    private final GpuMesh chunk;
    private final int chunkIndices;
    private final int level;
    private final double[] bounds = new double[6];

    public TerrainMesh(GlContext gl, HeightField field) {
        this.field = field;
        level = field.blockLevel(CHUNK_CELLS);
        Texture.Extent extent = Texture.Extent.flat(field.cellColumns() + 1, field.cellRows() + 1);
        heights = new Texture(
                gl, "terrain heights", Texture.Shape.FLAT, PixelFormat.R32F, extent, Sampling.NEAREST_CLAMP);
        slopes =
                new Texture(gl, "terrain slopes", Texture.Shape.FLAT, PixelFormat.RG16F, extent, Sampling.LINEAR_CLAMP);
        fill(gl);
        int cellsX = Math.min(CHUNK_CELLS, field.cellColumns());
        int cellsZ = Math.min(CHUNK_CELLS, field.cellRows());
        chunkIndices = 6 * cellsX * cellsZ;
        chunk = new GpuMesh(
                gl,
                "terrain chunk",
                VertexFormat.of(Attribute.UINT16X2),
                corners(cellsX, cellsZ),
                cells(cellsX, cellsZ));
    }

    /** Returns the level's terrains, in its order. */
    private static List<TerrainMesh> of(LoadContext context) {
        return context.scene().statics().ground().stream()
                .map(grid -> context.share(
                        TerrainMesh.class,
                        new Identity(grid.field()),
                        () -> new TerrainMesh(context.gl(), grid.field())))
                .toList();
    }

    /** Copies what an earlier mesh has on the GPU, and uploads what differs. */
    private void fill(GlContext gl) {
        SampleRange all = new SampleRange(0, 0, field.cellColumns(), field.cellRows());
        Optional<TerrainMesh> similar = mostSimilar(gl.shared().all(TerrainMesh.class), TerrainMesh::field, field);
        SampleRange changed =
                similar.flatMap(known -> field.difference(known.field)).orElse(all);
        if (similar.isEmpty() || 2 * changed.count() > all.count()) {
            upload(all);
            return;
        }
        heights.copyFrom(similar.get().heights);
        slopes.copyFrom(similar.get().slopes);
        if (!changed.isEmpty()) {
            // The rise at a sample follows from its neighbours.
            upload(changed.grown(1).intersection(all));
        }
    }

    /**
     * Returns what was made of the field that differs least from another one, as of the terrain before an edit; of those
     * with a grid of the same size, empty if there is none.
     */
    public static <T> Optional<T> mostSimilar(List<T> made, Function<T, HeightField> madeFrom, HeightField field) {
        long least = Long.MAX_VALUE;
        T found = null;
        for (T each : made) {
            long samples = field.difference(madeFrom.apply(each))
                    .map(range -> range.count())
                    .orElse(Long.MAX_VALUE);
            if (samples < least) {
                least = samples;
                found = each;
            }
        }
        return Optional.ofNullable(found);
    }

    private void upload(SampleRange samples) {
        int columns = samples.columns();
        FloatBuffer height = MemoryUtil.memAllocFloat(UPLOAD_ROWS * columns);
        FloatBuffer slope = MemoryUtil.memAllocFloat(2 * UPLOAD_ROWS * columns);
        for (int from = samples.firstRow(); from <= samples.lastRow(); from += UPLOAD_ROWS) {
            int rows = Math.min(UPLOAD_ROWS, samples.lastRow() + 1 - from);
            height.clear();
            slope.clear();
            for (int row = from; row < from + rows; row++) {
                for (int column = samples.firstColumn(); column <= samples.lastColumn(); column++) {
                    height.put(field.height(column, row));
                    slope.put((float) HeightFieldSurface.riseAlongX(field, column, row));
                    slope.put((float) HeightFieldSurface.riseAlongZ(field, column, row));
                }
            }
            Texture.Region part = new Texture.Region(samples.firstColumn(), from, columns, rows);
            heights.upload(0, part, MemoryUtil.memByteBuffer(height.flip()));
            slopes.upload(0, part, MemoryUtil.memByteBuffer(slope.flip()));
        }
        MemoryUtil.memFree(height);
        MemoryUtil.memFree(slope);
    }

    /** Returns the columns and rows of a grid of cells, row by row. */
    static ByteBuffer corners(int cellsX, int cellsZ) {
        ByteBuffer corners =
                ByteBuffer.allocateDirect(4 * (cellsX + 1) * (cellsZ + 1)).order(ByteOrder.nativeOrder());
        for (int row = 0; row <= cellsZ; row++) {
            for (int column = 0; column <= cellsX; column++) {
                corners.putShort((short) column).putShort((short) row);
            }
        }
        return corners.flip();
    }

    /** Returns two triangles for each cell, cut as {@link HeightField} cuts it, counter-clockwise seen from above. */
    static IntBuffer cells(int cellsX, int cellsZ) {
        IntBuffer indices = ByteBuffer.allocateDirect(24 * cellsX * cellsZ)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        int stride = cellsX + 1;
        for (int row = 0; row < cellsZ; row++) {
            for (int column = 0; column < cellsX; column++) {
                int least = row * stride + column;
                int greatest = least + stride + 1;
                indices.put(least).put(least + stride).put(greatest);
                indices.put(least).put(greatest).put(least + 1);
            }
        }
        return indices.flip();
    }

    /** Returns the height field. */
    public HeightField field() {
        return field;
    }

    /** Binds heights and slopes. */
    public void bind() {
        heights.bind(TextureUnit.TERRAIN_HEIGHTS);
        slopes.bind(TextureUnit.TERRAIN_SLOPES);
    }

    /** Draws the chunks that a frustum may contain, at full detail, with the current program and its uniforms. */
    public void draw(Frustum frustum, TerrainUniforms uniforms) {
        int mask = frustum.allPlanes();
        for (int row = 0; row < field.blockRows(level); row++) {
            for (int column = 0; column < field.blockColumns(level); column++) {
                field.writeBlock(level, column, row, bounds);
                if (frustum.classify(bounds, 0, mask) != Frustum.OUTSIDE) {
                    uniforms.chunk(field, column * CHUNK_CELLS, row * CHUNK_CELLS);
                    chunk.draw(0, chunkIndices);
                }
            }
        }
    }

    @Override
    public void close() {
        heights.close();
        slopes.close();
        chunk.close();
    }
}
