package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.portal.Portals;

/** Where the portals of the gun are among {@link Portals}; {@link #UNFIRED} for one that was not shot yet. */
public record Shots(int first, int second) {
    public static final int UNFIRED = -1;
    public static final Shots NONE = new Shots(UNFIRED, UNFIRED);

    /** The two that lead to each other. */
    public enum Colour {
        FIRST("first shot"),
        SECOND("second shot");

        private final String portalId;

        Colour(String portalId) {
            this.portalId = portalId;
        }

        /** The id of its portal. */
        public String portalId() {
            return portalId;
        }

        Colour other() {
            return this == FIRST ? SECOND : FIRST;
        }
    }

    /** The index of a shot's portal, or {@link #UNFIRED}. */
    public int portal(Colour shot) {
        return shot == Colour.FIRST ? first : second;
    }

    /** The one that comes first among the portals. */
    Colour earlier() {
        return first <= second ? Colour.FIRST : Colour.SECOND;
    }

    Shots with(Colour shot, int portal) {
        return shot == Colour.FIRST ? new Shots(portal, second) : new Shots(first, portal);
    }

    long hash(long seed) {
        return equals(NONE) ? seed : BitHash.join(BitHash.join(seed, first), second);
    }
}
