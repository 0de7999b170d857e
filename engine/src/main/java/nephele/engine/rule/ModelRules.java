package nephele.engine.rule;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.MeshAssets;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.model.Mesh;

/** Rules for models: parents form no cycle, meshes can be read, and impostors show what was meant and are few. */
final class ModelRules {
    static final LevelRule PARENTS = LevelRule.ofRecords((level, report) -> {
        Map<String, String> parents = new HashMap<>();
        level.models().forEach(model -> parents.put(model.id(), model.parent()));
        Map<String, Boolean> circular = new HashMap<>();
        LevelRule.each("models", level.models(), (entry, model) -> {
            String path = entry + ".parent";
            if (model.parent() != null && !parents.containsKey(model.parent())) {
                report.accept(Problem.error(path, "there is no model '" + model.parent() + "'"));
            } else if (circles(model.id(), parents, circular)) {
                report.accept(Problem.error(path, "'" + model.id() + "' hangs below itself: break the circle"));
            }
        });
    });

    static final LevelRule READABLE = new LevelRule(LevelRule.Stage.FILES, (level, assets, statics, report) -> {
        Map<String, Mesh> meshes = new HashMap<>();
        Map<String, String> objections = new HashMap<>();
        MeshAssets source = new MeshAssets(assets);
        long triangles = 0;
        for (int i = 0; i < level.models().size(); i++) {
            String file = level.models().get(i).file();
            if (!meshes.containsKey(file) && !objections.containsKey(file)) {
                String path = "models[" + i + "].file";
                try {
                    meshes.put(file, source.mesh(file, note -> report.accept(Problem.warning(path, note))));
                } catch (AssetException problem) {
                    objections.put(file, problem.getMessage());
                }
            }
            if (objections.containsKey(file)) {
                report.accept(Problem.error("models[" + i + "].file", objections.get(file))
                        .about(Topic.MISSING_ASSET));
                continue;
            }
            triangles += meshes.get(file).triangleCount();
            if (triangles > PlacedModels.MOST_TRIANGLES) {
                // Another rule reports this. Reading on could exhaust the memory.
                break;
            }
        }
        if (objections.isEmpty()) {
            placeable(level, meshes, report);
        }
    });

    static final LevelRule PLANTED = LevelRule.ofRecords((level, report) -> {
        Set<String> planted = new HashSet<>();
        level.models().stream().filter(ModelPlacement::isPlanted).forEach(model -> planted.add(model.id()));
        LevelRule.each("models", level.models(), (path, model) -> {
            if (model.parent() != null && planted.contains(model.parent())) {
                report.accept(Problem.error(
                        path + ".parent",
                        "'" + model.parent() + "' is planted at many places: give another parent, or none"));
            }
            planted(path, model, level, report);
        });
        count(level, report);
    });

    static final LevelRule MATT = LevelRule.ofRecords((level, report) -> {
        Map<String, Material> materials = new HashMap<>();
        level.materials().forEach(material -> materials.put(material.id(), material));
        LevelRule.each("models", level.models(), (path, model) -> {
            Material material = model.impostor() ? materials.get(model.material()) : null;
            if (material != null && material.normalTexture() != null) {
                report.accept(Problem.warning(
                        path + ".material",
                        "impostors are drawn without the normalTexture of '" + material.id()
                                + "': leave out impostor, or give a material without one"));
            }
        });
    });

    /** CPU time of a first picture above which {@code check} warns. */
    private static final double LONG_SECONDS = 10;

    /** CPU time to draw the atlas of one kind of plant, measured on one core of a machine of 2024. */
    private static final double SECONDS_PER_KIND = 0.17;

    /** CPU time to place one plant. */
    private static final double SECONDS_PER_PLANT = 6e-5;

    private static final double MEGABYTES_PER_KIND = 6;

    /** The impostors are not so many, or of so many kinds, that a picture of them takes long. */
    static final LevelRule IMPOSTOR_COST = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        if (PlantedModels.isIn(level)) {
            try {
                cost(plants(level), PlantedModels.kinds(statics), report);
            } catch (AssetException tooMany) {
                report.accept(Problem.error("models", tooMany.getMessage()));
            }
        }
    });

    private ModelRules() {}

    private static void placeable(Level level, Map<String, Mesh> meshes, Consumer<Problem> report) {
        try {
            PlacedModels placed = PlacedModels.of(level, meshes::get);
            reportEmpty(placed, report);
            ViewpointRules.reportInside(level, placed, report);
            if (!level.models().isEmpty()) {
                PortalRules.reportFree(level, placed, report);
            }
        } catch (AssetException problem) {
            report.accept(Problem.error("models", problem.getMessage()));
        } catch (IllegalArgumentException reportedByAnotherRule) {
            return;
        }
    }

    private static void reportEmpty(PlacedModels placed, Consumer<Problem> report) {
        for (PlacedModel model : placed.all()) {
            if (model.isEmpty() && !model.authored().isPlanted()) {
                report.accept(Problem.warning(
                        "models[" + model.index() + "]",
                        "'" + model.authored().id() + "' draws nothing: none of the triangles of "
                                + model.authored().file() + " has an area here; check its scale, or delete it"));
            }
        }
    }

    /**
     * Returns true if the chain of parents of {@code start} runs into a cycle.
     *
     * @param verdicts results of the ids visited so far; extended, so that each chain is followed once
     */
    private static boolean circles(String start, Map<String, String> parents, Map<String, Boolean> verdicts) {
        Set<String> walked = new HashSet<>();
        String id = start;
        while (id != null && !verdicts.containsKey(id) && walked.add(id)) {
            id = parents.get(id);
        }
        boolean circular = id != null && verdicts.getOrDefault(id, true);
        walked.forEach(each -> verdicts.put(each, circular));
        return circular;
    }

    private static void planted(String path, ModelPlacement model, Level level, Consumer<Problem> report) {
        if (!model.isPlanted()) {
            if (model.heightVariation() > 0) {
                report.accept(Problem.warning(
                        path + ".heightVariation", "a model at one place has one size: leave it out, or add a field"));
            }
            return;
        }
        if (!model.impostor()) {
            report.accept(Problem.error(path + ".field", "a field is of impostors: add \"impostor\": true"));
        }
        if (model.parent() != null) {
            report.accept(Problem.error(
                    path + ".parent", "a field has places of its own: leave out the parent, or the field"));
        }
        if (model.portalable()) {
            report.accept(Problem.error(
                    path + ".portalable", "a field's models are not solid: leave this out, or the field"));
        }
        BillboardRules.field(path + ".field", model.field(), level, report);
    }

    private static void count(Level level, Consumer<Problem> report) {
        long sum = 0;
        for (int i = 0; i < level.models().size(); i++) {
            ModelPlacement model = level.models().get(i);
            long before = sum;
            sum += !model.impostor() ? 0 : model.isPlanted() ? model.field().count() : 1;
            if (sum > PlantedModels.MOST && before <= PlantedModels.MOST) {
                report.accept(Problem.error(
                        "models[" + i + "]",
                        "a level shows at most " + PlantedModels.MOST + " impostors: lower the count of a field"));
            }
        }
    }

    private static void cost(long plants, int kinds, Consumer<Problem> report) {
        double seconds = kinds * SECONDS_PER_KIND + plants * SECONDS_PER_PLANT;
        if (seconds > LONG_SECONDS) {
            report.accept(Problem.warning(
                    "models",
                    plants + " impostors of " + kinds + " kinds need some " + Math.round(seconds)
                            + " s of a processor's time before the first picture, and "
                            + Math.round(kinds * MEGABYTES_PER_KIND) + " MB for their pictures: plant fewer, or let"
                            + " more of them have the same mesh, material and form"));
        }
    }

    private static long plants(Level level) {
        return level.models().stream()
                .filter(ModelPlacement::impostor)
                .mapToLong(model -> model.isPlanted() ? model.field().count() : 1)
                .sum();
    }
}
