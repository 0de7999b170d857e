package nephele.editor.problem;

import java.util.List;
import nephele.editor.mark.Mark;
import nephele.engine.level.Language;

/**
 * A problem or a hint about the open level.
 *
 * @param key names it in {@link nephele.engine.level.EditorNotes#ignoredProblems}; stays while entities are added,
 *     removed or sorted
 * @param path JSON path
 * @param rule the rule's message in English; {@code null} for a hint
 * @param hint the hint; {@code null} for a rule's message
 * @param marks its place in the world; may be empty
 * @param entity {@code section/id} of what it is about, {@code player} for the start, or {@code null}
 * @param fixes the best first
 */
public record LevelProblem(
        String key,
        ProblemSeverity severity,
        String path,
        String rule,
        ProblemText hint,
        List<Mark> marks,
        String entity,
        List<ProblemFix> fixes) {
    public LevelProblem {
        marks = List.copyOf(marks);
        fixes = List.copyOf(fixes);
    }

    /** Returns what is wrong and what to do; messages of rules are in English. */
    public String message(Language language) {
        return hint == null ? rule : hint.in(language);
    }

    LevelProblem withKey(String other) {
        return new LevelProblem(other, severity, path, rule, hint, marks, entity, fixes);
    }
}
