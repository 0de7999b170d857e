package nephele.editor.draw;

import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.math.Vec3;

/** The level's own textures and colours under an even light. */
final class UnlitLevel implements LevelDerivation {
    private final SurfacesLevel shown;
    private final DerivedRecords<Material, Material> materials = new DerivedRecords<>(UnlitLevel::plain);

    UnlitLevel(Vec3 background) {
        shown = new SurfacesLevel(EvenLight.before(background));
    }

    private static Material plain(Material said) {
        return new Material(
                said.id(),
                said.baseColour(),
                said.texture(),
                null,
                null,
                null,
                said.emission(),
                said.textureMetres(),
                false);
    }

    @Override
    public Level of(Level level) {
        return shown.of(materials.of(level.materials()), level.solids(), level.models(), level.bodies());
    }
}
