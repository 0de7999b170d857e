package nephele.editor.work;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;

/** The placed shapes of a level, followed through its edits. An edit that names the same files reads none. */
public final class FollowedPlacement {
    private final Aside aside;
    private PlacedLevel placed;

    /** @param aside runs what reads files */
    public FollowedPlacement(Aside aside) {
        this.aside = aside;
    }

    /**
     * Returns the shapes of a level.
     *
     * @throws nephele.engine.asset.AssetException if a file cannot be used
     */
    public PlacedLevel of(Level level, AssetSource assets) {
        PlacedLevel before = placed;
        if (before == null || before.assets() != assets) {
            placed = aside.get(() -> PlacedLevel.of(level, assets));
        } else if (before.level() != level) {
            boolean readsNothing = level.models() == before.level().models()
                    && level.terrains() == before.level().terrains();
            placed = readsNothing ? before.edited(level) : aside.get(() -> before.edited(level));
        }
        return placed;
    }

    /** Forgets the shapes, as after a file that could not be used. */
    public void forget() {
        placed = null;
    }
}
