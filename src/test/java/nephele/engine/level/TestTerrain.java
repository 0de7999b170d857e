package nephele.engine.level;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.function.IntBinaryOperator;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;

/** Terrains for tests. */
public final class TestTerrain {
    private TestTerrain() {}

    /** Returns a terrain of a map, 64 m square, with heights from 0 to 10 m and these layers. */
    public static Terrain said(String id, String map, Terrain.Layer... layers) {
        return new Terrain(
                id, map, Vec3.ZERO, new Terrain.Sides(64, 64), new Terrain.HeightRange(0, 10), List.of(layers), false);
    }

    /** Returns a field as the ground of a level. */
    public static StaticShape.HeightGrid grid(String id, HeightField field) {
        return new StaticShape.HeightGrid(0, said(id, "none"), field);
    }

    /** Returns assets with the map {@code map.r16}. */
    public static TestAssets map(int side, IntBinaryOperator valueAt) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * side * side).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < side * side; i++) {
            bytes.putShort((short) valueAt.applyAsInt(i % side, i / side));
        }
        return new TestAssets().file("map.r16", bytes.array());
    }

    /** Returns the value of a wavy map, 0 to 65535. */
    public static int wavy(int column, int row) {
        return (int) (32767 + 20_000 * Math.sin(0.45 * column) * Math.cos(0.37 * row) + 12_000 * Math.sin(0.21 * row));
    }
}
