package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.terrain.GroundProjections;
import nephele.engine.math.Frustum;
import nephele.engine.math.heightfield.DetailRanges;
import nephele.engine.math.heightfield.DetailTiles;
import nephele.engine.math.heightfield.DetailView;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldDetail;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/**
 * Draws a terrain of few triangles: one mesh of {@link HeightFieldDetail#TILE_CELLS}² cells, one instance for each tile
 * that {@link DetailTiles} selects for the view. {@code terrain-detail.glsl} places a vertex.
 */
public final class TerrainTiles implements GlObject {
    /** Ranges are made for scales that differ by this factor, the next greater one. */
    private static final double SCALE_STEP = 1.01;

    /** The number of sizes of views' pictures that are kept. */
    private static final int MOST_RANGES = 4;

    /** The slopes of tiles that are drawn by one program. */
    public enum Slopes {
        ALL,
        /** Nowhere is a projection of pictures but that from above seen, see {@link GroundProjections#GENTLE_RISE}. */
        GENTLE,
        STEEP;

        private boolean has(boolean isGentle) {
            return this == ALL || isGentle == (this == GENTLE);
        }
    }

    private final HeightFieldDetail detail;
    private final GpuMesh mesh;
    private final BufferTexture instances;
    private final DetailTiles tiles = new DetailTiles();
    private final List<DetailRanges> ranges = new ArrayList<>();
    private FloatBuffer values = MemoryUtil.memAllocFloat(DetailTiles.FLOATS * 256);

    public TerrainTiles(GlContext gl, HeightField field) {
        detail = detail(gl, field);
        int cells = HeightFieldDetail.TILE_CELLS;
        mesh = new GpuMesh(
                gl,
                "terrain tile",
                VertexFormat.of(Attribute.UINT16X2),
                TerrainMesh.corners(cells, cells),
                TerrainMesh.cells(cells, cells));
        instances = BufferTexture.changing(gl, "terrain tiles");
    }

    /** Measures a field; only where it differs from one of the same size that is on the GPU, as after an edit. */
    private static HeightFieldDetail detail(GlContext gl, HeightField field) {
        return TerrainMesh.mostSimilar(gl.shared().all(TerrainTiles.class), tiles -> tiles.detail.field(), field)
                .map(tiles -> HeightFieldDetail.edited(tiles.detail, field))
                .orElseGet(() -> HeightFieldDetail.of(field));
    }

    /** Returns the eye of a view. */
    public static DetailView detailView(View view) {
        Projection projection = view.projection();
        return DetailView.of(
                view.eye(),
                view.right(),
                view.up(),
                view.back().negated(),
                projection.tanHalfWidth(),
                projection.tanHalfHeight());
    }

    /**
     * Returns the greatest number of allowed distances in a picture that a length of 1 at distance 1 covers.
     *
     * @param width pixels
     * @param height pixels
     */
    public static double scale(Projection projection, int width, int height, double errorPixels) {
        double across = width / (2 * projection.tanHalfWidth());
        double along = height / (2 * projection.tanHalfHeight());
        return Math.max(across, along) / errorPixels;
    }

    /**
     * Selects the tiles that a frustum may contain, the nearer ones first.
     *
     * @param scale as {@link #scale} returns
     */
    public void select(DetailView view, double scale, Frustum frustum) {
        tiles.select(ranges(scale), view, frustum);
    }

    private boolean isGentle(int tile) {
        return tiles.rise(tile) <= GroundProjections.GENTLE_RISE;
    }

    /** Draws those selected tiles that have some slopes, with the current program. */
    public void draw(Slopes slopes) {
        int floats = DetailTiles.FLOATS * tiles.count();
        if (values.capacity() < floats) {
            values = MemoryUtil.memRealloc(values, 2 * floats);
        }
        values.clear();
        for (int tile = 0; tile < tiles.count(); tile++) {
            if (slopes.has(isGentle(tile))) {
                values.put(tiles.values(), DetailTiles.FLOATS * tile, DetailTiles.FLOATS);
            }
        }
        int count = values.flip().remaining() / DetailTiles.FLOATS;
        if (count > 0) {
            instances.upload(values);
            instances.bind(TextureUnit.TERRAIN_TILES);
            mesh.drawInstanced(0, 6 * HeightFieldDetail.TILE_CELLS * HeightFieldDetail.TILE_CELLS, count);
        }
    }

    private DetailRanges ranges(double scale) {
        double stepped = Math.pow(SCALE_STEP, Math.ceil(Math.log(scale) / Math.log(SCALE_STEP)));
        for (int i = 0; i < ranges.size(); i++) {
            if (ranges.get(i).scale() == stepped) {
                return ranges.get(i);
            }
        }
        if (ranges.size() == MOST_RANGES) {
            ranges.remove(0);
        }
        DetailRanges made = DetailRanges.of(detail, stepped);
        ranges.add(made);
        return made;
    }

    @Override
    public void close() {
        mesh.close();
        instances.close();
        MemoryUtil.memFree(values);
    }
}
