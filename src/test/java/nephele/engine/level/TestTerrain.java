package nephele.engine.level;

import java.util.List;
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
}
