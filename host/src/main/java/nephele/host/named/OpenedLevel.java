package nephele.host.named;

import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;

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
            placed = AssetProblems.named(this, () -> PlacedLevel.of(level(), assets()));
        }
        return placed;
    }
}
