package nephele.editor.problem;

import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;

/**
 * A problem or a hint about the open level.
 *
 * @param key names it in {@link nephele.engine.level.EditorNotes#ignoredProblems}; stays while entities are added,
 *     removed or sorted
 * @param path JSON path
 * @param message what is wrong and what to do; a rule's message is English in all languages
 * @param marks its place in the world; may be empty
 * @param entity what it is about, or {@code null}
 * @param fixes the best first
 */
public record LevelProblem(
        String key,
        ProblemSeverity severity,
        String path,
        Words message,
        List<Mark> marks,
        EntityRef entity,
        List<ProblemFix> fixes) {
    public LevelProblem {
        marks = List.copyOf(marks);
        fixes = List.copyOf(fixes);
    }

    LevelProblem withKey(String other) {
        return new LevelProblem(other, severity, path, message, marks, entity, fixes);
    }
}
