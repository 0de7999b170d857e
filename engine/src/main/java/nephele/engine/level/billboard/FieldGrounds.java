package nephele.engine.level.billboard;

import java.util.HashMap;
import java.util.Map;
import nephele.engine.level.Billboards;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;

/** The grounds of the fields of a level: a terrain, or the highest surfaces of everything. */
public final class FieldGrounds {
    private final StaticShapes statics;
    private final Map<String, Ground> terrains = new HashMap<>();
    private Ground surfaces;

    public FieldGrounds(StaticShapes statics) {
        this.statics = statics;
        for (StaticShape.HeightGrid grid : statics.ground()) {
            terrains.put(grid.id(), TerrainGround.of(grid));
        }
    }

    /** Returns the ground of a field; {@code null} if it names a terrain that there is not. */
    public Ground of(Billboards.Field field) {
        if (field.terrain() != null) {
            return terrains.get(field.terrain());
        }
        if (surfaces == null) {
            surfaces = new SurfaceGround(statics);
        }
        return surfaces;
    }
}
