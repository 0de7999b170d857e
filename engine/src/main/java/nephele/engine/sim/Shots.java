package nephele.engine.sim;

import nephele.engine.portal.Portals;

/** Where the portals of the gun are among {@link Portals}; {@link #UNFIRED} for one that was not shot yet. */
public record Shots(int first, int second) {
    public static final int UNFIRED = -1;
    public static final Shots NONE = new Shots(UNFIRED, UNFIRED);

    long hash(long seed) {
        return equals(NONE) ? seed : StateHash.join(StateHash.join(seed, first), second);
    }
}
