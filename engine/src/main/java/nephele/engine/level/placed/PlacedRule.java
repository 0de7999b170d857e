package nephele.engine.level.placed;

import java.util.function.Consumer;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;

/**
 * One thing that must hold in the world that follows from a level. It is asked only about levels in which the rules of
 * {@link nephele.engine.level.rule.LevelRules} find no error.
 */
public interface PlacedRule {
    /** Reports every breach, in the order of the file. */
    void check(Level level, StaticShapes statics, Consumer<Problem> report);
}
