package nephele.editor.draw;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.MirrorFaces;
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

    private final RecolouredLevel recoloured;
    private DerivedRecords<Solid, Solid> solids;
    private Set<String> mirrors;

    PortalableLevel(Vec3 background) {
        recoloured = new RecolouredLevel(
                MATERIALS,
                model -> Recoloured.model(model, model.portalable() ? PORTALABLE : OTHERS),
                BODY,
                background);
    }

    @Override
    public Level of(Level level) {
        Set<String> nowMirrors = MirrorFaces.materials(level.materials());
        if (!nowMirrors.equals(mirrors)) {
            mirrors = nowMirrors;
            solids = new DerivedRecords<>(
                    solid -> Recoloured.byPortals(solid, nowMirrors::contains, PORTALABLE, OTHERS));
        }
        return recoloured.of(level, solids.of(level.solids()));
    }
}
