package nephele.editor.document;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;

/** The placed shapes of a level, followed through its edits. An edit that names the same files reads none. */
public final class PlacedLevelCache {
    private final BackgroundReading background;
    private PlacedLevel placed;

    /** @param background runs what reads files */
    public PlacedLevelCache(BackgroundReading background) {
        this.background = background;
    }

    /**
     * Returns the shapes of a level.
     *
     * @throws nephele.engine.asset.AssetException if a file cannot be used
     */
    public PlacedLevel of(Level level, AssetSource assets) {
        PlacedLevel before = placed;
        if (before == null || before.assets() != assets) {
            placed = background.get(() -> PlacedLevel.of(level, assets));
        } else if (before.level() != level) {
            boolean readsNothing = level.models() == before.level().models()
                    && level.terrains() == before.level().terrains();
            placed = readsNothing ? before.edited(level) : background.get(() -> before.edited(level));
        }
        return placed;
    }

    /** Forgets the shapes, as after a file that could not be used. */
    public void forget() {
        placed = null;
    }
}
