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
        Set<String> rooted = new HashSet<>();
        for (int i = 0; i < level.models().size(); i++) {
            ModelPlacement model = level.models().get(i);
            String path = "models[" + i + "].parent";
            if (model.parent() != null && !parents.containsKey(model.parent())) {
                report.accept(Problem.error(path, "there is no model '" + model.parent() + "'"));
            } else if (circles(model.id(), parents, rooted)) {
                report.accept(Problem.error(path, "'" + model.id() + "' hangs below itself: break the circle"));
            }
        }
    };

    private ModelRules() {}

    /** @param rooted ids known to lead to a root; grows, so that a chain is walked once */
    private static boolean circles(String start, Map<String, String> parents, Set<String> rooted) {
        Set<String> walked = new HashSet<>();
        String id = start;
        while (id != null && !rooted.contains(id)) {
            if (!walked.add(id)) {
                return true;
            }
            id = parents.get(id);
        }
        rooted.addAll(walked);
        return false;
    }
}
