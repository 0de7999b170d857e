package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.portal.Portals;

/** The indices of the gun's portals among {@link Portals}; {@link #UNFIRED} for one that was not shot yet. */
public record Shots(int first, int second) {
    public static final int UNFIRED = -1;
    public static final Shots NONE = new Shots(UNFIRED, UNFIRED);

    /** One of the gun's two portals, which lead to each other. */
    public enum Colour {
        FIRST("first shot"),
        SECOND("second shot");

        private final String portalId;

        Colour(String portalId) {
            this.portalId = portalId;
        }

        /** Returns the id of its portal. */
        public String portalId() {
            return portalId;
        }

        Colour other() {
            return this == FIRST ? SECOND : FIRST;
        }
    }

    /** Returns the index of a shot's portal, or {@link #UNFIRED}. */
    public int portal(Colour shot) {
        return shot == Colour.FIRST ? first : second;
    }

    /** Returns the colour with the lower index; one that was not shot comes first. */
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
