package nephele.engine.collision;

import java.util.Arrays;
import nephele.engine.portal.Portals;
import nephele.engine.portal.ground.GroundStep;

/** The ground around each portal, see {@link GroundStep}; found on first use. Not thread-safe. */
final class PortalSteps {
    private final CollisionWorld statics;
    private final Portals portals;
    private final double[] metres;
    private final double[] deepest;

    PortalSteps(CollisionWorld statics, Portals portals) {
        this.statics = statics;
        this.portals = portals;
        metres = new double[portals.size()];
        Arrays.fill(metres, Double.NaN);
        deepest = metres.clone();
    }

    /** Returns how far the ground under a portal lies below it; {@link GroundStep#NO_GROUND} for one on a wall. */
    double metres(int portal) {
        if (Double.isNaN(metres[portal])) {
            metres[portal] = GroundStep.below(statics.grounds(), portals.portal(portal));
        }
        return metres[portal];
    }

    /** Returns how far the ground within the reach of a body beside a portal on ground lies below it. */
    double deepestMetres(int portal) {
        if (Double.isNaN(deepest[portal])) {
            deepest[portal] = metres(portal) < 0
                    ? 0
                    : GroundStep.deepest(statics.grounds(), portals.portal(portal), ApertureCutter.REACH_METRES);
        }
        return deepest[portal];
    }
}
