package nephele.engine.level.placed;

import java.util.function.Consumer;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;

/**
 * A rule on the world that follows from a level. It is applied only to levels that have shapes and no error
 * under {@link nephele.engine.level.rule.LevelRules}.
 */
public interface PlacedRule {
    /** Reports every violation, in the order of the file. */
    void check(Level level, StaticShapes statics, Consumer<Problem> report);
}
