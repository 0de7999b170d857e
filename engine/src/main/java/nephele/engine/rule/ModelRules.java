package nephele.engine.rule;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.MeshAssets;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.model.Mesh;

/** Parents of models form no cycle, and all meshes can be read and are few and near enough. */
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

    private ModelRules() {}

    private static void placeable(Level level, Map<String, Mesh> meshes, Consumer<Problem> report) {
        try {
            PlacedModels placed = PlacedModels.of(level, meshes::get);
            tellEmpty(placed, report);
            PlayerRules.reportInside(level, placed, report);
            if (!level.models().isEmpty()) {
                PortalRules.tellFree(level, placed, report);
            }
        } catch (AssetException problem) {
            report.accept(Problem.error("models", problem.getMessage()));
        } catch (IllegalArgumentException reportedByAnotherRule) {
            return;
        }
    }

    private static void tellEmpty(PlacedModels placed, Consumer<Problem> report) {
        for (PlacedModel model : placed.all()) {
            if (model.isEmpty() && !model.said().isPlanted()) {
                report.accept(Problem.warning(
                        "models[" + model.index() + "]",
                        "'" + model.said().id() + "' draws nothing: none of the triangles of "
                                + model.said().file() + " has an area here; check its scale, or delete it"));
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
}
