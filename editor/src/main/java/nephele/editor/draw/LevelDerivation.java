package nephele.editor.draw;

import nephele.editor.pane.ViewMode;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;

/** Makes the level that a view mode draws; it remembers the last one, so it belongs to one document. */
@FunctionalInterface
public interface LevelDerivation {
    /** Returns the level to draw; the same object if nothing that it shows has changed. */
    Level of(Level level);

    /**
     * Returns the derivation of a mode that draws surfaces.
     *
     * @param background linear radiance behind the level, except in the game's own picture
     */
    static LevelDerivation of(ViewMode mode, Vec3 background) {
        return switch (mode) {
            case LIT, WIREFRAME -> level -> level;
            case UNLIT -> new UnlitLevel(background);
            case PORTALABLE -> new PortalableLevel(background);
            case COLLISION -> new CollisionLevel(background);
        };
    }
}
