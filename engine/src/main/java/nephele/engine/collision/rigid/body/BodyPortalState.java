package nephele.engine.collision.rigid.body;

import java.util.Arrays;
import nephele.engine.math.Hash64;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/**
 * The portal state of the bodies: the portals on which each is active, those it went through in the last tick, and the
 * set of portals that the indices refer to. Empty while there are no portals. Immutable.
 */
public final class BodyPortalState {
    public static final BodyPortalState NONE = new BodyPortalState(Portals.NONE, null, null);

    /** Limit of the portals that a body goes through in a tick. */
    public static final int MOST = 8;

    private final Portals portals;
    private final long[] active;
    /** {@value #MOST} places a body, {@link Portals#CLOSED} after the last; {@code null} without crossings. */
    private final byte[] entered;

    public BodyPortalState(Portals portals, long[] active, byte[] entered) {
        this.portals = portals;
        this.active = active;
        this.entered = entered;
    }

    boolean isAt(Portals now) {
        return active == null ? now.size() == 0 : portals == now && entered == null;
    }

    BodyPortalState at(Portals now) {
        return active == null ? NONE : new BodyPortalState(now, active, null);
    }

    /**
     * Returns true if the masks were found with these portals, compared by value, so that a copied state continues
     * identically.
     */
    public boolean hasEqualPortals(Portals now) {
        boolean same = portals == now || portals.size() == now.size();
        for (int i = 0; same && portals != now && i < now.size(); i++) {
            Portal a = portals.portal(i);
            Portal b = now.portal(i);
            same = portals.partner(i) == now.partner(i)
                    && a.centre().equals(b.centre())
                    && a.frame().equals(b.frame())
                    && a.aperture().shape() == b.aperture().shape()
                    && a.aperture().widthMetres() == b.aperture().widthMetres()
                    && a.aperture().heightMetres() == b.aperture().heightMetres();
        }
        return same;
    }

    public Portals portals() {
        return portals;
    }

    public long active(int body) {
        return active == null ? 0 : active[body];
    }

    int count(int body) {
        int count = 0;
        while (entered != null && count < MOST && entered[MOST * body + count] != Portals.CLOSED) {
            count++;
        }
        return count;
    }

    public byte[] copyEntered() {
        return entered == null ? null : entered.clone();
    }

    int entered(int body, int place) {
        return entered[MOST * body + place];
    }

    long hash(long before) {
        long hash = before;
        for (int i = 0; active != null && i < active.length; i++) {
            hash = Hash64.combine(hash, active[i]);
        }
        return entered == null ? hash : Hash64.combine(hash, Arrays.hashCode(entered));
    }
}
