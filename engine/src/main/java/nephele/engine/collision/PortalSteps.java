package nephele.engine.collision;

import java.util.Arrays;
import nephele.engine.portal.Portals;
import nephele.engine.portal.ground.GroundStep;

/** The {@link GroundStep} of each portal, found on first use. Not thread-safe. */
final class PortalSteps {
    private final CollisionWorld statics;
    private final Portals portals;
    private final double[] metres;

    PortalSteps(CollisionWorld statics, Portals portals) {
        this.statics = statics;
        this.portals = portals;
        metres = new double[portals.size()];
        Arrays.fill(metres, Double.NaN);
    }

    double metres(int portal) {
        if (Double.isNaN(metres[portal])) {
            metres[portal] = GroundStep.below(statics.grounds(), portals.portal(portal));
        }
        return metres[portal];
    }
}
