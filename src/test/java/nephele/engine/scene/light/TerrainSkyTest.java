package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import nephele.engine.level.TestTerrain;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The sky that a terrain leaves open; after an edit of heights it is found again where that is seen, and is the same. */
@Execution(ExecutionMode.CONCURRENT)
class TerrainSkyTest {
    private static HeightField field(int side, int atColumn, int atRow, double most) {
        return HeightField.of(new Vec3(-40, 3, 10), 0.7, 1.1, side, side, (column, row) -> {
            double d = Math.hypot(column - atColumn, row - atRow) / 6;
            return TestTerrain.wavy(column, row) * 1e-4 + (d < 1 ? most * (1 - d) : 0);
        });
    }

    @Test
    void anEditFindsWhatANewFieldHas() {
        for (int side : new int[] {65, 300}) {
            HeightField flat = field(side, 30, 20, 0);
            TerrainSky before = TerrainSky.of(flat);
            for (HeightField edited : new HeightField[] {field(side, 30, 20, 9), field(side, 0, side - 1, -5)}) {
                TerrainSky fresh = TerrainSky.of(edited);
                assertArrayEquals(
                        fresh.values(), TerrainSky.edited(before, edited).values());
                assertFalse(Arrays.equals(before.values(), fresh.values()));
                assertArrayEquals(
                        before.values(), TerrainSky.edited(fresh, flat).values(), "and back");
            }
        }
    }

    @Test
    void aFieldOfAnotherSizeIsFoundAnew() {
        TerrainSky small = TerrainSky.of(field(20, 5, 5, 3));
        TerrainSky other = TerrainSky.edited(small, field(33, 5, 5, 3));
        assertEquals(33, other.columns());
        assertArrayEquals(TerrainSky.of(field(33, 5, 5, 3)).values(), other.values());
    }

    @Test
    void flatGroundSeesTheWholeSky() {
        HeightField flat = HeightField.of(Vec3.ZERO, 1, 9, 9, (column, row) -> 2);
        for (byte value : TerrainSky.of(flat).values()) {
            assertEquals(255, value & 0xff);
        }
        assertEquals(1, TerrainSky.share(flat, 3, 3), 1e-9);
    }
}
