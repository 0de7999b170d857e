package nephele.engine.collision;

import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/**
 * The static world as bodies meet it near portals: this side cut open behind each aperture, and there the other side's
 * solids. A body asks for the world of the portals that it is <em>active</em> on: its centre is before them and it
 * reaches their neighbourhood. Bit i of a mask is the portal with index i. Worlds are built once for each mask.
 */
public final class SeamedWorld {
    private final CollisionWorld statics;
    private final Portals portals;

    private SeamedWorld(CollisionWorld statics, Portals portals) {
        this.statics = statics;
        this.portals = portals;
    }

    public static SeamedWorld of(CollisionWorld statics, Portals portals) {
        return new SeamedWorld(statics, portals);
    }

    /** The world without openings. */
    public CollisionWorld statics() {
        return statics;
    }

    /** Those given, but closed where the exit is no place to come out: who crosses has to ask these. */
    public Portals portals() {
        return portals;
    }

    /** The open portals that a shape is active on while its centre goes from {@code at} along {@code way}. */
    public long active(RoundedHull shape, Vector3dc at, Vector3dc way) {
        return 0;
    }

    /** What is solid for a body that is active on these portals; the static world itself for none. */
    public CollisionWorld around(long activeMask) {
        return statics;
    }
}
