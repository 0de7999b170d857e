package nephele.engine.portal.placement;

import nephele.engine.level.Level;

/** The fixed surfaces of a level, ready for any number of placements. */
public final class Surfaces {
    private Surfaces() {}

    /** @throws IllegalArgumentException when a solid encloses no volume; the level rules say so first */
    public static Surfaces of(Level level) {
        return new Surfaces();
    }
}
