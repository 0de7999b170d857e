package nephele.engine.rule;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import nephele.engine.level.Billboards;
import nephele.engine.level.Body;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.Emitter;
import nephele.engine.level.Exit;
import nephele.engine.level.Hint;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.json.WrittenMaterials;
import nephele.engine.level.placed.LevelRule;

/** Every id is unique in its section, and every reference names an existing record. */
final class IdRules {
    static final LevelRule UNIQUE = LevelRule.ofRecords((level, report) -> {
        unique("environment.clouds", level.environment().clouds(), Cloud::id, report);
        unique("cameras", level.cameras(), Camera::id, report);
        unique("materials", level.materials(), Material::id, report);
        unique("solids", level.solids(), Solid::id, report);
        unique("lights", level.lights(), Light::id, report);
        unique("portals", level.portals(), PortalSpec::id, report);
        unique("models", level.models(), ModelPlacement::id, report);
        unique("bodies", level.bodies(), Body::id, report);
        unique("exits", level.exits(), Exit::id, report);
        unique("emitters", level.emitters(), Emitter::id, report);
        unique("terrains", level.terrains(), Terrain::id, report);
        unique("billboards", level.billboards(), Billboards::id, report);
        unique("hints", level.hints(), Hint::id, report);
    });

    static final LevelRule MATERIALS = LevelRule.ofRecords((level, report) -> {
        Set<String> known = new HashSet<>();
        level.materials().forEach(material -> known.add(material.id()));
        BiConsumer<String, String> material = (path, id) -> material(path, id, known, report);
        LevelRule.each("solids", level.solids(), (path, solid) -> {
            material.accept(path, solid.material());
            SolidFaces.authored(solid)
                    .forEach((name, face) ->
                            material.accept(path + "." + SolidFaces.path(solid, name), face.material()));
        });
        LevelRule.each("models", level.models(), (path, model) -> material.accept(path, model.material()));
        LevelRule.each("bodies", level.bodies(), (path, body) -> material.accept(path, body.material()));
        LevelRule.each(
                "terrains",
                level.terrains(),
                (path, terrain) -> LevelRule.each(
                        path + ".layers", terrain.layers(), (at, layer) -> material.accept(at, layer.material())));
    });

    private IdRules() {}

    private static <T> void unique(String section, List<T> records, Function<T, String> id, Consumer<Problem> report) {
        Map<String, Integer> first = new HashMap<>();
        for (int i = 0; i < records.size(); i++) {
            String name = id.apply(records.get(i));
            Integer before = first.putIfAbsent(name, i);
            if (before != null) {
                report.accept(Problem.error(
                                section + "[" + i + "].id",
                                "'" + name + "' is already the id of " + section + "[" + before + "]: give it another")
                        .about(Topic.DUPLICATE_ID));
            }
        }
    }

    private static void material(String path, String material, Set<String> known, Consumer<Problem> report) {
        if (material != null && !known.contains(material)) {
            report.accept(Problem.error(path + ".material", WrittenMaterials.noMaterial(material))
                    .about(Topic.MISSING_MATERIAL));
        }
    }
}
