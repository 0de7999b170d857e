package nephele.engine.level;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Models hang below models, without circles; iterative, so that ten thousand of them in a chain are no trouble. */
final class ModelRules {
    static final LevelRule PARENTS = (level, assets, report) -> {
        Map<String, String> parents = new HashMap<>();
        level.models().forEach(model -> parents.put(model.id(), model.parent()));
        Map<String, Boolean> circular = new HashMap<>();
        for (int i = 0; i < level.models().size(); i++) {
            ModelPlacement model = level.models().get(i);
            String path = "models[" + i + "].parent";
            if (model.parent() != null && !parents.containsKey(model.parent())) {
                report.accept(Problem.error(path, "there is no model '" + model.parent() + "'"));
            } else if (circles(model.id(), parents, circular)) {
                report.accept(Problem.error(path, "'" + model.id() + "' hangs below itself: break the circle"));
            }
        }
    };

    private ModelRules() {}

    /** @param verdicts of the ids walked so far; grows, so that a chain is walked once */
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
