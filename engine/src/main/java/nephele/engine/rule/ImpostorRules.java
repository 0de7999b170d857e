package nephele.engine.rule;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.planted.PlantedModels;

/** Rules for models that are drawn as impostors: which can be planted over fields, and what their pictures show. */
final class ImpostorRules {
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

    private ImpostorRules() {}

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
}
