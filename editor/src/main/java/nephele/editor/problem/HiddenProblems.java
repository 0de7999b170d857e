package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Level;

/** The problems that an author has decided to keep; they are stored in the level. */
public final class HiddenProblems {
    private HiddenProblems() {}

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
        return with(level, keys);
    }

    /** Returns the level with a problem shown again. */
    public static Level show(Level level, LevelProblem problem) {
        List<String> keys = new ArrayList<>(level.editor().ignoredProblems());
        return keys.remove(problem.key()) ? with(level, keys) : level;
    }

    private static Level with(Level level, List<String> keys) {
        EditorNotes notes = level.editor();
        return level.with(new EditorNotes(notes.groups(), notes.hidden(), notes.locked(), List.copyOf(keys)));
    }
}
