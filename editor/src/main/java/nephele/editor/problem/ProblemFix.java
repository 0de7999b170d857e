package nephele.editor.problem;

import java.util.function.UnaryOperator;
import nephele.engine.level.Language;
import nephele.engine.level.Level;

/**
 * A remedy that one click applies.
 *
 * @param text label of the button
 * @param argument what fills the label's place; empty for none
 * @param change returns the repaired level; the same object if what it repairs is no longer in the level
 */
public record ProblemFix(ProblemText text, String argument, UnaryOperator<Level> change) {
    /** Returns the label in a language. */
    public String label(Language language) {
        return text.in(language, argument);
    }
}
