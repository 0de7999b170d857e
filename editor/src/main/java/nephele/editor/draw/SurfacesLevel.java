package nephele.editor.draw;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;

/** A level of surfaces alone; it stays the same object while none of its lists is another one. */
final class SurfacesLevel {
    private final Level empty;
    private Level shown;

    /** Creates a level without lights, portals, mirrors, exits and player. */
    SurfacesLevel(Environment environment) {
        empty = Level.of("", "", environment, List.of());
        shown = empty;
    }

    Level of(List<Material> materials, List<Solid> solids, List<ModelPlacement> models, List<Body> bodies) {
        boolean isSame = materials == shown.materials()
                && solids == shown.solids()
                && models == shown.models()
                && bodies == shown.bodies();
        if (!isSame) {
            shown = empty.with(materials, solids, bodies, models);
        }
        return shown;
    }
}
