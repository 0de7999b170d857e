package nephele.engine.rule;

import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.level.Material;
import nephele.engine.level.Problem;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Vec3;

/** Mirrors are flat faces of solids and reflect by their base colour alone. */
final class MirrorRules {
    static final LevelRule FLAT = LevelRule.ofRecords((level, report) -> {
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        if (mirrors.isEmpty()) {
            return;
        }
        LevelRule.each("materials", level.materials(), (path, material) -> bare(path, material, report));
        LevelRule.each("models", level.models(), (path, model) -> onlySolids(path, model.material(), mirrors, report));
        LevelRule.each("bodies", level.bodies(), (path, body) -> onlySolids(path, body.material(), mirrors, report));
        LevelRule.each("terrains", level.terrains(), (path, terrain) -> {
            LevelRule.each(
                    path + ".layers",
                    terrain.layers(),
                    (at, layer) -> onlySolids(at, layer.material(), mirrors, report));
        });
    });

    private MirrorRules() {}

    private static void onlySolids(String path, String material, Set<String> mirrors, Consumer<Problem> report) {
        if (material != null && mirrors.contains(material)) {
            report.accept(Problem.error(
                    path + ".material",
                    "'" + material + "' is a mirror, and only faces of solids can be: give another material"));
        }
    }

    private static void bare(String path, Material material, Consumer<Problem> report) {
        if (!material.mirror()) {
            return;
        }
        without(path + ".texture", material.texture() != null, report);
        without(path + ".roughness", material.roughness() != null, report);
        without(path + ".metallic", material.metallic() != null, report);
        without(path + ".normalTexture", material.normalTexture() != null, report);
        without(path + ".emission", !material.emission().equals(Vec3.ZERO), report);
    }

    private static void without(String path, boolean isThere, Consumer<Problem> report) {
        if (isThere) {
            report.accept(Problem.error(path, "a mirror reflects by its baseColour alone: leave this out"));
        }
    }
}
