package nephele.editor.draw;

import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** A level in even light whose surfaces have other materials. */
final class RecolouredLevel {
    private final List<Material> materials;
    private final DerivedRecords<ModelPlacement, ModelPlacement> models;
    private final DerivedRecords<Body, Body> bodies;
    private final SurfacesLevel shown;

    /**
     * @param body id of the material of every body
     * @param background linear radiance behind the level
     */
    RecolouredLevel(List<Material> materials, UnaryOperator<ModelPlacement> models, String body, Vec3 background) {
        this.materials = materials;
        this.models = new DerivedRecords<>(models);
        bodies = new DerivedRecords<>(each -> each.withMaterial(body));
        shown = new SurfacesLevel(EvenLight.before(background));
    }

    /** Returns the level with solids that have their materials already. */
    Level of(Level level, List<Solid> solids) {
        return shown.of(materials, solids, models.of(level.models()), bodies.of(level.bodies()));
    }
}
