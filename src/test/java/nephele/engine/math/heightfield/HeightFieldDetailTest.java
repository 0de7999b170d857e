package nephele.engine.math.heightfield;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.workshop.art.bench.BenchTerrain;
import nephele.workshop.prove.geometry.DrawnDetail;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HeightFieldDetailTest {
    private static final double PIXELS = 90;

    private static HeightField noise(int columns, int rows) {
        return HeightField.of(new Vec3(-columns / 2.0, 5, -rows / 2.0), 1, columns, rows, BenchTerrain::metres);
    }

    private static DetailView view(double x, double y, double z, double yaw) {
        Vec3 right = new Vec3(-Math.sin(yaw), 0, Math.cos(yaw));
        Vec3 forward = new Vec3(Math.cos(yaw) * 0.96, -0.28, Math.sin(yaw) * 0.96);
        return DetailView.of(new Vec3(x, y, z), right, right.cross(forward), forward, 1.05, 0.63);
    }

    private static DetailTiles everywhere(DetailRanges ranges, DetailView view) {
        DetailTiles tiles = new DetailTiles();
        tiles.select(ranges, view, Frustum.everything());
        return tiles;
    }

    /** The greatest distance at a sample, by {@link HeightFieldSurface} of a field with every second, fourth … sample. */
    @Test
    void errorsAreTheGreatestDistancesFromTheCoarserTriangles() {
        HeightField field = noise(65, 65);
        HeightFieldDetail detail = HeightFieldDetail.of(field);
        assertEquals(3, detail.top());
        for (int level = 1; level <= detail.top(); level++) {
            int stride = 1 << level;
            int its = (field.cellColumns() >> level) + 1;
            HeightField coarser = HeightField.of(
                    field.origin(), stride, its, its, (column, row) -> field.height(column * stride, row * stride));
            double worst = 0;
            for (int sample = 0; sample < 65 * 65; sample++) {
                double x = field.x(sample % 65);
                double z = field.z(sample / 65);
                double off = HeightFieldSurface.y(coarser, x, z) - HeightFieldSurface.y(field, x, z);
                worst = Math.max(worst, Math.abs(off));
            }
            assertEquals(worst, greatestError(detail, level), 1e-5, "level " + level);
            assertTrue(greatestError(detail, level) >= worst, "level " + level);
        }
    }

    private static double greatestError(HeightFieldDetail detail, int level) {
        int side = Math.max(1, 8 >> level);
        double greatest = 0;
        for (int tile = 0; tile < side * side; tile++) {
            greatest = Math.max(greatest, detail.error(level, tile % side, tile / side));
        }
        return greatest;
    }

    /**
     * Every edge of a drawn triangle is that of another one in the opposite direction, bit for bit, or lies on the field's
     * border: there is neither a gap nor a vertex on another triangle's edge.
     */
    @ParameterizedTest
    @CsvSource({"257, 257", "200, 150", "130, 257", "97, 9"})
    void theDrawnTrianglesHaveNoCracks(int columns, int rows) {
        HeightField field = noise(columns, rows);
        HeightFieldDetail detail = HeightFieldDetail.of(field);
        SplittableRandom random = new SplittableRandom(columns);
        int levels = 0;
        for (int camera = 0; camera < 12; camera++) {
            DetailView view = view(
                    columns * (random.nextDouble() - 0.5),
                    40 + 80 * random.nextDouble(),
                    rows * (random.nextDouble() - 0.5),
                    7 * random.nextDouble());
            DetailTiles tiles = everywhere(DetailRanges.of(detail, PIXELS * random.nextDouble()), view);
            Map<Edge, Integer> open = new HashMap<>();
            new DrawnDetail(field, view, tiles).triangles((a, b, c) -> {
                join(open, a, b);
                join(open, b, c);
                join(open, c, a);
            });
            for (Edge edge : open.keySet()) {
                assertTrue(isOnBorder(field, edge), "camera " + camera + ": " + edge);
            }
            levels |= levels(tiles);
        }
        assertTrue(Integer.bitCount(levels) > (columns == 257 && rows == 257 ? 2 : 1), "tiles of several levels");
    }

    private record Edge(DetailVertex from, DetailVertex to) {}

    private static void join(Map<Edge, Integer> open, DetailVertex from, DetailVertex to) {
        if (open.remove(new Edge(to, from)) == null) {
            open.merge(new Edge(from, to), 1, Integer::sum);
        }
    }

    private static boolean isOnBorder(HeightField field, Edge edge) {
        DetailVertex a = edge.from();
        DetailVertex b = edge.to();
        return a.column() == b.column() && (a.column() == 0 || a.column() == field.cellColumns())
                || a.row() == b.row() && (a.row() == 0 || a.row() == field.cellRows());
    }

    private static int levels(DetailTiles tiles) {
        int levels = 0;
        for (int tile = 0; tile < tiles.count(); tile++) {
            levels |= 1 << (int) tiles.values()[DetailTiles.FLOATS * tile + 3];
        }
        return levels;
    }

    /** While the eye moves evenly, the drawn surface moves evenly, also where tiles are exchanged: half the way, half the step. */
    @Test
    void theDrawnSurfaceMovesWithoutJumps() {
        HeightField field = noise(129, 129);
        DetailRanges ranges = DetailRanges.of(HeightFieldDetail.of(field), PIXELS);
        double coarse = greatestStep(field, ranges, 0.2, 60);
        double fine = greatestStep(field, ranges, 0.05, 240);
        assertTrue(coarse > 0, "the surface changes");
        assertTrue(fine < 0.4 * coarse, "a quarter of the step: " + fine + " after " + coarse);
        assertTrue(coarse < 0.1, "metres: " + coarse);
    }

    private static double greatestStep(HeightField field, DetailRanges ranges, double metres, int frames) {
        double[] before = null;
        double greatest = 0;
        for (int frame = 0; frame <= frames; frame++) {
            DetailView view = view(-60 + metres * frame, 80, -60 + 0.7 * metres * frame, 0.7);
            double[] now = drawn(field, view, everywhere(ranges, view));
            for (int i = 0; before != null && i < now.length; i++) {
                greatest = Math.max(greatest, Math.abs(now[i] - before[i]));
            }
            before = now;
        }
        return greatest;
    }

    private static double[] drawn(HeightField field, DetailView view, DetailTiles tiles) {
        double[] heights = new double[(field.cellColumns() + 1) * (field.cellRows() + 1)];
        new DrawnDetail(field, view, tiles)
                .samples((column, row, height) -> heights[row * (field.cellColumns() + 1) + column] = height);
        return heights;
    }

    /** A plane has no error, so it takes one tile of each level around the eye; one pixel allows few triangles far away. */
    @Test
    void flatGroundTakesFewTriangles() {
        HeightField flat = HeightField.of(new Vec3(-256, 0, -256), 1, 513, 513, (column, row) -> 3);
        DetailTiles tiles = everywhere(DetailRanges.of(HeightFieldDetail.of(flat), 600), view(0, 20, 0, 0));
        int triangles = 2 * 64 * tiles.count();
        assertTrue(triangles < flat.triangles() / 8, "triangles: " + triangles);
    }

    /** A tile knows the steepest of its samples, also where a field ends within it and where it is the only one. */
    @ParameterizedTest
    @CsvSource({"65, 65", "70, 43", "6, 5"})
    void risesAreTheGreatestOfTheSmoothSurface(int columns, int rows) {
        HeightField field = noise(columns, rows);
        HeightFieldDetail detail = HeightFieldDetail.of(field);
        for (int level = 0; level <= detail.top(); level++) {
            int width = HeightFieldDetail.TILE_CELLS << level;
            var tiles = detail.tiles(level);
            double[] greatest = new double[tiles.columns() * tiles.rows()];
            for (int sample = 0; sample < columns * rows; sample++) {
                int column = sample % columns;
                int row = sample / columns;
                double rise = Math.max(
                        Math.abs(HeightFieldSurface.riseAlongX(field, column, row)),
                        Math.abs(HeightFieldSurface.riseAlongZ(field, column, row)));
                for (int tile = 0; tile < greatest.length; tile++) {
                    int x = column - tile % tiles.columns() * width;
                    int z = row - tile / tiles.columns() * width;
                    if (x >= 0 && z >= 0 && x <= width && z <= width) {
                        greatest[tile] = Math.max(greatest[tile], rise);
                    }
                }
            }
            for (int tile = 0; tile < greatest.length; tile++) {
                assertEquals(greatest[tile], tiles.rise()[tile], 1e-5, "level " + level);
            }
        }
    }

    /** After an edit, only tiles with other heights are measured; the result is that of a new field. */
    @Test
    void anEditMeasuresWhatANewFieldHas() {
        HeightField before = noise(129, 100);
        HeightFieldDetail known = HeightFieldDetail.of(before);
        for (int[] at : new int[][] {{0, 0}, {64, 64}, {63, 8}, {26, 41}, {128, 99}, {17, 96}}) {
            HeightField after = HeightField.of(
                    before.origin(),
                    before.cellX(),
                    before.cellZ(),
                    129,
                    100,
                    (column, row) ->
                            before.height(column, row) + (Math.hypot(column - at[0], row - at[1]) < 3 ? 7.5 : 0));
            HeightFieldDetail edited = HeightFieldDetail.edited(known, after);
            HeightFieldDetail fresh = HeightFieldDetail.of(after);
            for (int level = 0; level <= fresh.top(); level++) {
                assertArrayEquals(
                        fresh.tiles(level).error(), edited.tiles(level).error());
                assertArrayEquals(
                        fresh.tiles(level).coarserError(), edited.tiles(level).coarserError());
                assertArrayEquals(fresh.tiles(level).step(), edited.tiles(level).step());
                assertArrayEquals(
                        fresh.tiles(level).spread(), edited.tiles(level).spread());
                assertArrayEquals(fresh.tiles(level).rise(), edited.tiles(level).rise());
            }
        }
    }

    @Test
    void differencesOfFieldsAreFound() {
        HeightField before = noise(40, 30);
        assertEquals(Optional.of(SampleRange.NONE), before.difference(before.at(new Vec3(5, 6, 7))));
        assertEquals(Optional.empty(), before.difference(noise(40, 31)));
        HeightField after = HeightField.of(
                before.origin(),
                before.cellX(),
                before.cellZ(),
                40,
                30,
                (column, row) ->
                        before.height(column, row) + (column == 7 && row == 3 || column == 39 && row == 12 ? 1 : 0));
        assertEquals(Optional.of(new SampleRange(7, 3, 39, 12)), after.difference(before));
    }
}
