package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import nephele.editor.pane.Mark;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Level;

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
        Severity severity,
        String path,
        Words message,
        List<Mark> marks,
        EntityRef entity,
        List<Fix> fixes) {
    public LevelProblem {
        marks = List.copyOf(marks);
        fixes = List.copyOf(fixes);
    }

    LevelProblem withKey(String other) {
        return new LevelProblem(other, severity, path, message, marks, entity, fixes);
    }

    /** Returns true if a problem is hidden. */
    public static boolean isHidden(Level level, LevelProblem problem) {
        return level.editor().ignoredProblems().contains(problem.key());
    }

    /** Returns the level with a problem hidden. */
    public static Level hide(Level level, LevelProblem problem) {
        if (isHidden(level, problem)) {
            return level;
        }
        List<String> keys = new ArrayList<>(level.editor().ignoredProblems());
        keys.add(problem.key());
        EditorNotes notes = level.editor();
        return level.with(new EditorNotes(notes.groups(), notes.hidden(), notes.locked(), List.copyOf(keys)));
    }

    /**
     * A remedy that one click applies.
     *
     * @param label of the button and of the step in the history
     * @param change returns the repaired level; the same object if what it repairs is no longer in the level
     */
    public record Fix(Words label, UnaryOperator<Level> change) {}

    /** The severity of a problem; {@code check} does not report a HINT. */
    public enum Severity {
        ERROR,
        WARNING,
        HINT
    }
}
