package nephele.editor.problem;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.WordFormats;

/** Names of problems that stay while entities are added, removed or sorted: topic, entity and place inside it. */
final class ProblemKey {
    private ProblemKey() {}

    static String of(Level level, Problem problem) {
        String place = EntityPath.of(level, problem.path())
                .map(path -> path.reference(level).text() + path.rest())
                .orElse(problem.path());
        return WordFormats.Choice.word(problem.subject().topic()) + " " + place;
    }

    /** Returns the problems with a number after each key that is there already. */
    static List<LevelProblem> numbered(List<LevelProblem> problems) {
        Map<String, Integer> counts = new HashMap<>();
        List<LevelProblem> numbered = new ArrayList<>();
        for (LevelProblem problem : problems) {
            int count = counts.merge(problem.key(), 1, Integer::sum);
            numbered.add(count == 1 ? problem : problem.withKey(problem.key() + " #" + count));
        }
        return List.copyOf(numbered);
    }
}
