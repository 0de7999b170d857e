package nephele.engine.portal;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * The portals that exist at a time, and their pairing. A value: a shot makes another. Portals are identified by their
 * index here; a portal without a partner is closed.
 */
public final class Portals {
    public static final Portals NONE = new Portals(List.of(), List.of());
    /** The partner of a closed portal. */
    public static final int CLOSED = -1;

    private final List<Portal> portals;
    private final List<Integer> partners;
    private final Passage[] passages;
    private final Plane[] planes;

    /** @param partners for each portal the index of its partner, or {@link #CLOSED} */
    public Portals(List<Portal> portals, List<Integer> partners) {
        this.portals = List.copyOf(portals);
        this.partners = List.copyOf(partners);
        passages = new Passage[portals.size()];
        planes = portals.stream().map(Portals::planeOf).toArray(Plane[]::new);
        for (int i = 0; i < passages.length; i++) {
            int partner = partners.get(i);
            passages[i] = partner == CLOSED ? null : Passage.between(portals.get(i), portals.get(partner));
        }
    }

    private static Plane planeOf(Portal portal) {
        Vec3 n = portal.normal();
        Vec3 c = portal.centre();
        return new Plane(n.x(), n.y(), n.z(), n.x() * c.x() + n.y() * c.y() + n.z() * c.z());
    }

    /** Returns the portals with which a level starts, in its order. */
    public static Portals of(Level level) {
        List<String> ids = level.portals().stream().map(PortalSpec::id).toList();
        List<Portal> portals = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        for (PortalSpec spec : level.portals()) {
            portals.add(Portal.of(spec));
            partners.add(ids.indexOf(spec.linkedTo()));
        }
        return new Portals(portals, partners);
    }

    /** Returns the number of portals, closed ones included. */
    public int size() {
        return portals.size();
    }

    /** Returns a portal by its index. */
    public Portal portal(int index) {
        return portals.get(index);
    }

    /** Returns the index of the portal's partner, or {@link #CLOSED}. */
    public int partner(int index) {
        return partners.get(index);
    }

    /** Returns the plane of a portal, with its normal towards the front. */
    public Plane plane(int index) {
        return planes[index];
    }

    /** Returns true if a portal has a partner. */
    public boolean isOpen(int index) {
        return passages[index] != null;
    }

    /** Returns the map from an open portal to its partner, {@code null} for a closed one. */
    public Passage passage(int index) {
        return passages[index];
    }
}
