package nephele.editor.draw;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** A level coloured by collision: one colour each for solids, models and movable bodies. */
final class CollisionLevel implements LevelDerivation {
    private static final String SOLID = "solid";
    private static final String MODEL = "model";
    private static final String BODY = "body";
    private static final List<Material> MATERIALS = List.of(
            Recoloured.material(SOLID, new Vec3(0.32, 0.42, 0.55)),
            Recoloured.material(MODEL, new Vec3(0.55, 0.75, 0.4)),
            Recoloured.material(BODY, new Vec3(0.9, 0.5, 0.15)));

    private final RecolouredLevel recoloured;
    private final DerivedRecords<Solid, Solid> solids = new DerivedRecords<>(solid -> Recoloured.solid(solid, SOLID));

    CollisionLevel(Vec3 background) {
        recoloured = new RecolouredLevel(MATERIALS, model -> Recoloured.model(model, MODEL), BODY, background);
    }

    @Override
    public Level of(Level level) {
        return recoloured.of(level, solids.of(level.solids()));
    }
}
