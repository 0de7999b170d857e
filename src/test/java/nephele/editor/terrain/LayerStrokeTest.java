package nephele.editor.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.function.IntBinaryOperator;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Strokes change layer maps by their formulas; texels are 2 m by 1 m, with the first one at (80, −65). */
@Execution(ExecutionMode.CONCURRENT)
class LayerStrokeTest {
    private static final int COLUMNS = 21;
    private static final int ROWS = 31;
    private static final Terrain GROUND = new Terrain(
            "ground",
            "map.png",
            new Vec3(100, 5, -50),
            new Terrain.Sides(40, 30),
            new Terrain.HeightRange(0, 0),
            List.of(),
            false);

    private static TerrainBrush brush(Effect effect, double strength) {
        return new TerrainBrush(effect, 6, strength, 2);
    }

    /** Returns a map with one layer and a weight at each texel. */
    private static LayerMap map(int layer, IntBinaryOperator weight) {
        LayerMap map = LayerMap.blank(COLUMNS, ROWS);
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            map.texels()[2 * i] = (byte) layer;
            map.texels()[2 * i + 1] = (byte) weight.applyAsInt(i % COLUMNS, i / COLUMNS);
        }
        return map;
    }

    /** Returns what a stroke with one dab at (101, −50) makes of a map. */
    private static LayerStroke dab(LayerMap map, Effect effect, double strength) {
        return new LayerStroke(GROUND, map, brush(effect, strength), 101, -50);
    }

    private static double fraction(int column, int row, double x) {
        double d = Math.hypot(80 + 2 * column - x, row - 15) / 6;
        return d < 1 ? Math.pow(1 - d * d, 2) : 0;
    }

    private static void assertTexel(LayerMap map, int column, int row, int layer, double weight) {
        String where = column + ", " + row;
        assertEquals(Math.round(255 * weight), map.weight(column, row), 1, where);
        assertEquals(map.weight(column, row) == 0 ? 0 : layer, map.layer(column, row), where);
    }

    @Test
    void paintingCoversByTheFalloffTimesTheStrength() {
        LayerMap painted = dab(LayerMap.blank(COLUMNS, ROWS), Effect.PAINT, 0.5).map();
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                assertTexel(painted, column, row, 2, 0.5 * fraction(column, row, 101));
            }
        }
    }

    @Test
    void dabsOfAStrokeCoverWhatIsLeft() {
        LayerStroke stroke = dab(map(2, (c, r) -> 51), Effect.PAINT, 0.5);
        stroke.to(104, -50);
        LayerMap painted = stroke.map();
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                double left = 0.8;
                for (double x = 101; x <= 104; x += 1.5) {
                    left *= 1 - 0.5 * fraction(column, row, x);
                }
                assertTexel(painted, column, row, 2, 1 - left);
            }
        }
    }

    @Test
    void erasingTakesPaintOfEveryLayerAway() {
        LayerMap erased = dab(map(5, (c, r) -> 200), Effect.ERASE, 1).map();
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                assertTexel(erased, column, row, 5, 200 / 255.0 * (1 - fraction(column, row, 101)));
            }
        }
        LayerStroke whole = new LayerStroke(GROUND, map(5, (c, r) -> 200), brush(Effect.ERASE, 1), 100, -50);
        assertTexel(whole.map(), 10, 15, 0, 0);
    }

    /** Full paint of layer 1 becomes layer 2 where the stroke covers half, and leaves no gap between the two. */
    @Test
    void paintOverPaintKeepsTheSumOfBoth() {
        LayerMap painted = dab(map(1, (c, r) -> 255), Effect.PAINT, 1).map();
        int changed = 0;
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                boolean isNew = fraction(column, row, 101) >= 0.5;
                changed += isNew ? 1 : 0;
                assertTexel(painted, column, row, isNew ? 2 : 1, 1);
            }
        }
        assertTrue(changed > 9, "texels of the middle: " + changed);
        LayerMap half = dab(map(1, (c, r) -> 102), Effect.PAINT, 1).map();
        double fraction = fraction(10, 15, 101);
        assertTexel(half, 10, 15, 2, 0.4 * (1 - fraction) + fraction);
        double little = fraction(10, 19, 101);
        assertTrue(little > 0 && little < 0.4 * (1 - little));
        assertTexel(half, 10, 19, 1, 0.4);
    }

    @Test
    void aStrokeThatIsTooWeakSaysSoUntilItsDabsAddUp() {
        LayerStroke stroke = dab(map(1, (c, r) -> 255), Effect.PAINT, 0.3);
        assertFalse(stroke.isChange());
        assertEquals(Optional.of(TerrainText.TOO_WEAK.words()), stroke.objection());
        stroke.to(104, -50);
        assertTrue(stroke.isChange());
        assertFalse(dab(LayerMap.blank(COLUMNS, ROWS), Effect.ERASE, 1).isChange());
        assertEquals(
                Optional.empty(),
                dab(LayerMap.blank(COLUMNS, ROWS), Effect.ERASE, 1).objection());
        assertFalse(dab(map(2, (c, r) -> 255), Effect.PAINT, 1).isChange(), "painted so already");
    }

    @Test
    void texelsThatNoDabReachesKeepTheirBytes() {
        LayerMap before = map(200, (c, r) -> c == 20 ? 9 : 0);
        byte[] bytes = before.texels().clone();
        LayerStroke stroke = dab(before, Effect.PAINT, 1);
        LayerMap first = stroke.map();
        byte[] firstBytes = first.texels().clone();
        stroke.to(104, -50);
        assertNotSame(first, stroke.map());
        assertArrayEquals(firstBytes, first.texels());
        assertArrayEquals(bytes, before.texels());
        assertEquals(200, stroke.map().layer(0, 0));
        assertEquals(9, stroke.map().weight(20, 30));
    }
}
