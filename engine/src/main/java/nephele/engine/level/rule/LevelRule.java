package nephele.engine.level.rule;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;

/** A rule on the values of a level that reading each value alone cannot check. */
public interface LevelRule {
    /** Reports every violation to {@code report}, in the order of the file. */
    void check(Level level, AssetSource assets, Consumer<Problem> report);

    /** Passes every entry of a list to {@code use} with its path, such as {@code solids[3]}. */
    static <T> void each(String section, List<T> entries, BiConsumer<String, T> use) {
        for (int i = 0; i < entries.size(); i++) {
            use.accept(section + "[" + i + "]", entries.get(i));
        }
    }
}
