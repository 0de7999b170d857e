package nephele.engine.math.heightfield;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A field that was edited is, block for block, the field that is made of its heights. */
@Execution(ExecutionMode.CONCURRENT)
class HeightFieldEditTest {
    private static final int COLUMNS = 70;
    private static final int ROWS = 53;

    private static HeightField of(float[] heights) {
        return HeightField.of(new Vec3(1, 2, 3), 0.5, 0.75, COLUMNS, ROWS, (c, r) -> heights[r * COLUMNS + c]);
    }

    private static void assertSameBlocks(HeightField expected, HeightField edited) {
        assertEquals(SampleRange.NONE, edited.difference(expected).orElseThrow());
        assertEquals(expected.bounds(), edited.bounds());
        double[] some = new double[6];
        double[] other = new double[6];
        for (int level = 0; level <= expected.pyramid().top(); level++) {
            for (int row = 0; row < expected.blockRows(level); row++) {
                for (int column = 0; column < expected.blockColumns(level); column++) {
                    expected.writeBlock(level, column, row, some);
                    edited.writeBlock(level, column, row, other);
                    assertArrayEquals(some, other, level + ": " + column + ", " + row);
                }
            }
        }
    }

    @Test
    void editsMakeTheFieldOfTheirHeights() {
        SplittableRandom random = new SplittableRandom(4);
        float[] heights = new float[COLUMNS * ROWS];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (float) random.nextDouble(10);
        }
        HeightField field = of(heights);
        for (int step = 0; step < 60; step++) {
            int width = 1 + random.nextInt(6);
            int column = step % 3 == 0 ? COLUMNS - width : random.nextInt(COLUMNS - width);
            int row = step % 5 == 0 ? ROWS - width : random.nextInt(ROWS - width);
            for (int i = 0; i < width * width; i++) {
                heights[(row + i / width) * COLUMNS + column + i % width] = (float) random.nextDouble(-20, 20);
            }
            HeightField before = field;
            field = field.edited((c, r) -> heights[r * COLUMNS + c]);
            assertSameBlocks(of(heights), field);
            assertEquals(new Vec3(1, 2, 3), before.origin());
        }
    }

    @Test
    void theSameHeightsAreTheSameField() {
        HeightField field = of(new float[COLUMNS * ROWS]);
        assertSame(field, field.edited((c, r) -> 0));
        assertThrows(IllegalArgumentException.class, () -> field.edited((c, r) -> c == 3 ? Double.NaN : 0));
    }
}
