package nephele.engine.named;

import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.LevelFile;
import nephele.engine.level.placed.PlacedLevel;

/** A level that a user named, checked; what follows from it is derived when it is first asked for, and once. */
public final class OpenedLevel {
    private final LevelFile.Opened read;
    private PlacedLevel placed;

    public OpenedLevel(LevelFile.Opened read) {
        this.read = read;
    }

    /** How messages call it. */
    public String file() {
        return read.file();
    }

    public Level level() {
        return read.level();
    }

    public AssetSource assets() {
        return read.assets();
    }

    /** What the player should know about how it was found, such as that the backup stood in. */
    public Optional<String> notice() {
        return read.notice();
    }

    /** @throws nephele.engine.level.LevelFormatException where the level names a mesh that cannot be used */
    public synchronized PlacedLevel placed() {
        if (placed == null) {
            placed = AssetComplaint.named(this, () -> PlacedLevel.of(level(), assets()));
        }
        return placed;
    }
}
