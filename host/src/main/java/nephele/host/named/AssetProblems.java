package nephele.host.named;

import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.rule.LevelRules;

/** Reports an asset failure during level building in the form of {@code check}: level file, JSON path, reason. */
public final class AssetProblems {
    private AssetProblems() {}

    /**
     * Returns the result of {@code work}. After an asset failure it runs the rules that open every asset; they cost as
     * much as loading and are therefore not run before.
     *
     * @throws LevelFormatException if the level names an unusable asset
     */
    public static <T> T named(OpenedLevel opened, Supplier<T> work) {
        try {
            return work.get();
        } catch (AssetException failure) {
            var errors = LevelRules.checkRecordsAndFiles(opened.level(), opened.assets()).stream()
                    .filter(Problem::isError)
                    .toList();
            if (errors.isEmpty()) {
                throw failure;
            }
            var complaint = new LevelFormatException(opened.file(), errors);
            complaint.addSuppressed(failure);
            throw complaint;
        }
    }
}
