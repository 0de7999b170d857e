package nephele.editor.draw.derived;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
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

    private final Vec3 background;
    private final DerivedRecords<Solid, Solid> solids = new DerivedRecords<>(solid -> Recoloured.solid(solid, SOLID));
    private final DerivedRecords<ModelPlacement, ModelPlacement> models =
            new DerivedRecords<>(model -> Recoloured.model(model, MODEL));
    private final DerivedRecords<Body, Body> bodies = new DerivedRecords<>(body -> Recoloured.body(body, BODY));
    private EvenLight.Surfaces shown;
    private Level derived;

    CollisionLevel(Vec3 background) {
        this.background = background;
    }

    @Override
    public Level of(Level level) {
        EvenLight.Surfaces now = new EvenLight.Surfaces(
                MATERIALS, solids.of(level.solids()), models.of(level.models()), bodies.of(level.bodies()));
        if (!now.isSame(shown)) {
            shown = now;
            derived = EvenLight.level(now, background);
        }
        return derived;
    }
}
