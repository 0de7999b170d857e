package nephele.engine.level;

import java.util.function.Consumer;
import nephele.engine.asset.AssetSource;

/** One thing that must hold between the values of a level, beyond what reading checks of each alone. */
public interface LevelRule {
    /** Hands every breach to {@code report}, in the order of the file. */
    void check(Level level, AssetSource assets, Consumer<Problem> report);
}
