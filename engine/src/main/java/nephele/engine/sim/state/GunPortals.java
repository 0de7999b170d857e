package nephele.engine.sim.state;

import java.util.List;
import nephele.engine.math.Hash64;
import nephele.engine.portal.Portals;

/** The indices of the gun's portals among {@link Portals}; {@link #UNFIRED} for one that was not shot yet. */
public record GunPortals(int first, int second) {
    public static final int UNFIRED = -1;
    public static final GunPortals NONE = new GunPortals(UNFIRED, UNFIRED);

    /** One of the gun's two portals, which lead to each other. */
    public enum Colour {
        FIRST("first shot"),
        SECOND("second shot");

        /** Both colours, without the new array of {@link #values}. */
        public static final List<Colour> BOTH = List.of(values());

        private final String portalId;

        Colour(String portalId) {
            this.portalId = portalId;
        }

        /** Returns the id of its portal. */
        public String portalId() {
            return portalId;
        }

        public Colour other() {
            return this == FIRST ? SECOND : FIRST;
        }
    }

    /** Returns the index of a shot's portal, or {@link #UNFIRED}. */
    public int portal(Colour shot) {
        return shot == Colour.FIRST ? first : second;
    }

    public GunPortals with(Colour shot, int portal) {
        return shot == Colour.FIRST ? new GunPortals(portal, second) : new GunPortals(first, portal);
    }

    long hash(long seed) {
        return equals(NONE) ? seed : Hash64.combine(Hash64.combine(seed, first), second);
    }
}
