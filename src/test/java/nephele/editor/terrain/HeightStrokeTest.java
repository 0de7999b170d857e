package nephele.editor.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntBinaryOperator;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Strokes change heights by their formulas; a unit of the map is a thousandth of a metre, cells are 2 m by 1 m. */
@Execution(ExecutionMode.CONCURRENT)
class HeightStrokeTest {
    private static final int COLUMNS = 21;
    private static final int ROWS = 31;
    private static final Terrain GROUND = new Terrain(
            "ground",
            "map.png",
            new Vec3(100, 5, -50),
            new Terrain.Sides(40, 30),
            new Terrain.HeightRange(-10, 55.535),
            List.of(),
            false);

    private static HeightMap map(IntBinaryOperator value) {
        short[] values = new short[COLUMNS * ROWS];
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) value.applyAsInt(i % COLUMNS, i / COLUMNS);
        }
        return new HeightMap(COLUMNS, ROWS, 16, values);
    }

    private static double x(int column) {
        return 80 + 2 * column;
    }

    private static double z(int row) {
        return -65 + row;
    }

    private static double weight(int column, int row, double x, double z, double radius) {
        double d = Math.hypot(x(column) - x, z(row) - z) / radius;
        return d < 1 ? Math.pow(1 - d * d, 2) : 0;
    }

    private static void assertMap(HeightMap actual, IntBinaryOperator value) {
        assertArrayEquals(map(value).values(), actual.values());
    }

    @Test
    void raisingAddsTheFalloffTimesAFifthOfTheRadius() {
        TerrainBrush brush = new TerrainBrush(Effect.RAISE, 5, 0.5);
        HeightStroke stroke = new HeightStroke(GROUND, map((c, r) -> 20_000), brush, 101, -48.5);
        assertEquals(0.5, brush.riseMetres(), 1e-12);
        assertMap(stroke.map(), (c, r) -> (int) Math.round(20_000 + 500 * weight(c, r, 101, -48.5, 5)));
        assertEquals(5 + 20_000e-3 - 10 - 5, stroke.heightMetres(x(0), z(0)), 1e-9);
    }

    @Test
    void loweringTakesAsMuchAway() {
        HeightMap flat = map((c, r) -> 20_000);
        HeightStroke stroke = new HeightStroke(GROUND, flat, new TerrainBrush(Effect.LOWER, 6, 1), 100, -50);
        assertMap(stroke.map(), (c, r) -> (int) Math.round(20_000 - 1200 * weight(c, r, 100, -50, 6)));
        assertEquals(Effect.LOWER, Effect.RAISE.inverted());
        assertEquals(Effect.SMOOTH, Effect.SMOOTH.inverted());
    }

    @Test
    void flatteningGoesToTheHeightUnderTheFirstPress() {
        IntBinaryOperator slope = (c, r) -> 10_000 + 100 * c + 10 * r;
        HeightStroke stroke = new HeightStroke(GROUND, map(slope), new TerrainBrush(Effect.FLATTEN, 6, 1), 101, -50.5);
        double flat = 10_000 + 100 * 10.5 + 10 * 14.5;
        assertMap(stroke.map(), (c, r) -> (int)
                Math.round(slope.applyAsInt(c, r) + weight(c, r, 101, -50.5, 6) * (flat - slope.applyAsInt(c, r))));
        stroke.to(113, -50.5);
        assertEquals(flat, stroke.map().value(16, 14), 20, "the height of the first press, not of the last place");
    }

    @Test
    void smoothingGoesTowardsTheMeanAround() {
        // A quarter of the radius is 1.5 m: one column and two rows on each side.
        HeightStroke stroke = new HeightStroke(
                GROUND,
                map((c, r) -> c == 10 && r == 15 ? 11_500 : 10_000),
                new TerrainBrush(Effect.SMOOTH, 6, 1),
                x(10),
                z(15));
        assertMap(stroke.map(), (c, r) -> {
            double mean = Math.abs(c - 10) <= 1 && Math.abs(r - 15) <= 2 ? 10_100 : 10_000;
            double value = c == 10 && r == 15 ? 11_500 : 10_000;
            return (int) Math.round(value + weight(c, r, x(10), z(15), 6) * (mean - value));
        });
    }

    @Test
    void smoothingAtACornerTakesTheMeanOfWhatIsThere() {
        HeightStroke stroke =
                new HeightStroke(GROUND, map((c, r) -> 1000 * c), new TerrainBrush(Effect.SMOOTH, 6, 1), x(0), z(0));
        assertEquals(500, stroke.map().value(0, 0));
    }

    @Test
    void dabsFollowAtAQuarterOfTheRadiusHoweverTheWayIsCut() {
        TerrainBrush brush = new TerrainBrush(Effect.RAISE, 8, 0.25);
        HeightMap flat = map((c, r) -> 20_000);
        HeightStroke whole = new HeightStroke(GROUND, flat, brush, 90, -50);
        whole.to(105, -50);
        HeightStroke parts = new HeightStroke(GROUND, flat, brush, 90, -50);
        for (double x : new double[] {90.5, 90.5, 93, 99.25, 105}) {
            parts.to(x, -50);
        }
        assertArrayEquals(whole.map().values(), parts.map().values());
        assertMap(whole.map(), (c, r) -> {
            float value = 20_000;
            for (double x = 90; x <= 105; x += 2) {
                value = (float) (value + 400 * weight(c, r, x, -50, 8));
            }
            return Math.round(value);
        });
    }

    /** A way of 10⁹ m has as many dabs as its part at the terrain, and of 1e300 m too. */
    @Test
    void aStrokeThatLeavesTheTerrainCostsNoMoreThanItsPartThere() {
        for (double far : new double[] {1e3, 1e9, 1e300}) {
            int[] dabs = {0};
            Dabs path = new Dabs(GROUND, 1.5, 6, 100, -50);
            path.to(100 + far, -50, (x, z) -> {
                dabs[0]++;
                assertEquals(0, (x - 100) % 1.5, 1e-6);
            });
            assertTrue(dabs[0] >= 17 && dabs[0] <= 20, far + " m: " + dabs[0]);
            path.to(100 + far, -50 + far, (x, z) -> dabs[0] = 999);
            assertTrue(dabs[0] < 999, "beside the terrain");
        }
        HeightStroke near =
                new HeightStroke(GROUND, map((c, r) -> 20_000), new TerrainBrush(Effect.RAISE, 6, 1), 90, -50);
        HeightStroke far =
                new HeightStroke(GROUND, map((c, r) -> 20_000), new TerrainBrush(Effect.RAISE, 6, 1), 90, -50);
        near.to(150, -50);
        far.to(1e9, -50);
        assertArrayEquals(near.map().values(), far.map().values());
    }

    @Test
    void aSmallBrushReachesASampleAndABorderCutsIt() {
        HeightMap flat = map((c, r) -> 20_000);
        HeightStroke small = new HeightStroke(GROUND, flat, new TerrainBrush(Effect.RAISE, 0.25, 1), 101, -50.5);
        assertFalse(Arrays.equals(flat.values(), small.map().values()));
        HeightStroke corner = new HeightStroke(GROUND, flat, new TerrainBrush(Effect.RAISE, 5, 1), x(0), z(0));
        assertEquals(21_000, corner.map().value(0, 0));
        HeightStroke beside = new HeightStroke(GROUND, flat, new TerrainBrush(Effect.RAISE, 5, 1), 200, 0);
        assertArrayEquals(flat.values(), beside.map().values());
    }

    @Test
    void heightsStayWithinTheMap() {
        HeightStroke up =
                new HeightStroke(GROUND, map((c, r) -> 65_000), new TerrainBrush(Effect.RAISE, 5, 1), x(10), z(15));
        assertEquals(65_535, up.map().value(10, 15));
        assertTrue(up.isAtLimit());
        HeightStroke down =
                new HeightStroke(GROUND, map((c, r) -> 300), new TerrainBrush(Effect.LOWER, 5, 1), x(10), z(15));
        assertEquals(0, down.map().value(10, 15));
        assertTrue(down.isAtLimit());
        assertFalse(new HeightStroke(GROUND, map((c, r) -> 300), TerrainBrush.INITIAL, x(10), z(15)).isAtLimit());
    }

    @Test
    void aMapThatWasReturnedDoesNotChange() {
        HeightStroke stroke = new HeightStroke(GROUND, map((c, r) -> 20_000), TerrainBrush.INITIAL, 100, -50);
        HeightMap first = stroke.map();
        short[] values = first.values().clone();
        stroke.to(110, -50);
        assertNotSame(first, stroke.map());
        assertArrayEquals(values, first.values());
    }
}
