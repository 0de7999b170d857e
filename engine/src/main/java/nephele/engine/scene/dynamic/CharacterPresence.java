package nephele.engine.scene.dynamic;

import nephele.engine.level.Level;

/** Tells if a player's character may ever be visible; its resources are built only if it may. */
public enum CharacterPresence {
    NEVER,
    POSSIBLE;

    /** Returns whether a character, or the sphere of an observer in its place, may be visible in a level. */
    public CharacterPresence in(Level level) {
        return level.observerStart() != null ? POSSIBLE : this;
    }
}
