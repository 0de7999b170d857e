package nephele.engine.level.placed;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;

/** A check of a level. Each check is a constant of this type and a line of {@code rule.LevelRules.ALL}, the one list. */
public record LevelRule(Stage stage, Check check) {
    /** What a check needs, from the cheapest to the dearest. */
    public enum Stage {
        /** The level's records. */
        RECORDS,
        /** Its pictures, meshes and height maps. */
        FILES,
        /** Its shapes; the editor applies such a check also to a level in which another one has found errors. */
        LAYOUT,
        /** Its shapes, and no error of any other check of records and files. */
        WORLD
    }

    /** Reports every violation to {@code report}, in the order of the file. */
    @FunctionalInterface
    public interface Check {
        /** @param statics {@code null} in checks of records and of files */
        void apply(Level level, AssetSource assets, StaticShapes statics, Consumer<Problem> report);
    }

    /** Returns a check of the level's records alone. */
    public static LevelRule ofRecords(BiConsumer<Level, Consumer<Problem>> check) {
        return new LevelRule(Stage.RECORDS, (level, assets, statics, report) -> check.accept(level, report));
    }

    /** Passes every entry of a list to {@code use} with its path, such as {@code solids[3]}. */
    public static <T> void each(String section, List<T> entries, BiConsumer<String, T> use) {
        for (int i = 0; i < entries.size(); i++) {
            use.accept(section + "[" + i + "]", entries.get(i));
        }
    }
}
