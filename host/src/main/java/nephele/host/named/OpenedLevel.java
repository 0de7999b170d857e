package nephele.host.named;

import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.rule.LevelRules;
import nephele.engine.sim.replay.Replay;

/** A checked level that a user named. Derived data is computed lazily and once. */
public final class OpenedLevel {
    private final LevelFile.Opened read;
    private PlacedLevel placed;

    public OpenedLevel(LevelFile.Opened read) {
        this.read = read;
    }

    /** Returns the level's name for messages. */
    public String file() {
        return read.file();
    }

    /** Returns the level as read. */
    public Level level() {
        return read.level();
    }

    /** Returns the level's assets. */
    public AssetSource assets() {
        return read.assets();
    }

    /** Returns a notice for the player about how the level was found, such as that a backup was used. */
    public Optional<String> notice() {
        return read.notice();
    }

    /** Returns another version of the level, derived from {@link #placed}. */
    public OpenedLevel edited(PlacedLevel other) {
        OpenedLevel edited = new OpenedLevel(new LevelFile.Opened(file(), other.level(), assets(), notice()));
        edited.placed = other;
        return edited;
    }

    /**
     * Returns the level with derived transforms and meshes; thread-safe.
     *
     * @throws nephele.engine.level.json.LevelFormatException if the level names an unusable mesh
     */
    public synchronized PlacedLevel placed() {
        if (placed == null) {
            placed = reporting(() -> PlacedLevel.of(level(), assets()));
        }
        return placed;
    }

    /**
     * Returns the result of {@code work} on this level. It reports an asset failure in the form of {@code check}: level
     * file, JSON path, reason. The rules that open every asset run only after a failure, as they cost as much as loading.
     *
     * @throws LevelFormatException if the level names an unusable asset
     */
    public <T> T reporting(Supplier<T> work) {
        try {
            return work.get();
        } catch (AssetException failure) {
            var errors = LevelRules.checkRecordsAndFiles(level(), assets()).stream()
                    .filter(Problem::isError)
                    .toList();
            if (errors.isEmpty()) {
                throw failure;
            }
            var complaint = new LevelFormatException(file(), errors);
            complaint.addSuppressed(failure);
            throw complaint;
        }
    }

    /**
     * Checks that a replay was recorded in this level.
     *
     * @param replayFile its name for messages
     * @param warnings receives a line if the level has changed since the recording
     * @throws LevelFormatException if the replay names another level
     */
    public void requireRecordedHere(Replay replay, String replayFile, PrintStream warnings) {
        String name = level().name();
        if (replay.levelName() != null && !replay.levelName().equals(name)) {
            String message = "was recorded in the level '" + replay.levelName() + "', and " + file() + " is '" + name
                    + "': play it in its own level";
            throw new LevelFormatException(replayFile, List.of(Problem.error("levelName", message)));
        }
        String sha256 = replay.levelSha256();
        if (sha256 != null && !sha256.equalsIgnoreCase(LevelJson.sha256(level()))) {
            String message = file() + " has changed since this was recorded: it may go another way";
            warnings.println(Problem.warning("levelSha256", message).line(replayFile));
        }
    }
}
