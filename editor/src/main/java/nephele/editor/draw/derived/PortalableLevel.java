package nephele.editor.draw.derived;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.MirrorFaces;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** Faces that take portals bright, all others dark. */
final class PortalableLevel implements LevelDerivation {
    private static final String PORTALABLE = "portalable";
    private static final String OTHERS = "others";
    private static final String BODY = "body";
    private static final List<Material> MATERIALS = List.of(
            Recoloured.material(PORTALABLE, new Vec3(0.72, 0.9, 1)),
            Recoloured.material(OTHERS, new Vec3(0.085, 0.07, 0.065)),
            Recoloured.material(BODY, new Vec3(0.2, 0.14, 0.09)));

    private final Vec3 background;
    private final DerivedRecords<ModelPlacement, ModelPlacement> models =
            new DerivedRecords<>(model -> Recoloured.model(model, model.portalable() ? PORTALABLE : OTHERS));
    private final DerivedRecords<Body, Body> bodies = new DerivedRecords<>(body -> Recoloured.body(body, BODY));
    private DerivedRecords<Solid, Solid> solids;
    private Set<String> mirrors;
    private EvenLight.Surfaces shown;
    private Level derived;

    PortalableLevel(Vec3 background) {
        this.background = background;
    }

    @Override
    public Level of(Level level) {
        Set<String> nowMirrors = MirrorFaces.materials(level.materials());
        if (!nowMirrors.equals(mirrors)) {
            mirrors = nowMirrors;
            solids = new DerivedRecords<>(
                    solid -> Recoloured.byPortals(solid, nowMirrors::contains, PORTALABLE, OTHERS));
        }
        EvenLight.Surfaces now = new EvenLight.Surfaces(
                MATERIALS, solids.of(level.solids()), models.of(level.models()), bodies.of(level.bodies()));
        if (!now.isSame(shown)) {
            shown = now;
            derived = EvenLight.level(now, background);
        }
        return derived;
    }
}
