package nephele.engine.named;

import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.level.LevelFormatException;
import nephele.engine.level.LevelRules;
import nephele.engine.level.Problem;

/** An asset that fails while a level is built is told as {@code check} tells it: level file, JSON path, reason. */
public final class AssetComplaint {
    private AssetComplaint() {}

    /**
     * What {@code work} gives. The rules that open every asset run only after a failure: they cost what loading costs.
     *
     * @throws LevelFormatException where the level names what cannot be used
     */
    public static <T> T named(OpenedLevel opened, Supplier<T> work) {
        try {
            return work.get();
        } catch (AssetException failure) {
            var errors = LevelRules.check(opened.level(), opened.assets()).stream()
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
