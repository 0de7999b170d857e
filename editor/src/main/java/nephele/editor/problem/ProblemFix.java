package nephele.editor.problem;

import java.util.function.UnaryOperator;
import nephele.editor.text.Words;
import nephele.engine.level.Level;

/**
 * A remedy that one click applies.
 *
 * @param label of the button and of the step in the history
 * @param change returns the repaired level; the same object if what it repairs is no longer in the level
 */
public record ProblemFix(Words label, UnaryOperator<Level> change) {}
