package nephele.engine.portal.ground;

import java.util.List;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.portal.Portal;

/** How far the ground under a portal lies below it. */
public final class GroundStep {
    /** Said of a portal that is not on ground. */
    public static final double NO_GROUND = -1;

    /** Allowance for rounding and for portals that follow flat ground by least squares. */
    private static final double TOLERANCE_METRES = 1.1e-3;

    private static final double MOST_METRES = 2 * GroundSeat.MOST_UNEVEN_METRES + TOLERANCE_METRES;

    private GroundStep() {}

    /**
     * Returns the greatest distance in metres of the ground under aperture and rim from the portal's plane, or {@link
     * #NO_GROUND} if the portal does not lie on one of the terrains.
     */
    public static double below(List<HeightField> terrains, Portal portal) {
        for (HeightField field : terrains) {
            ApertureGround ground = ApertureGround.under(field, portal);
            if (ground.size() > 0 && ground.highest() <= TOLERANCE_METRES && ground.lowest() >= -MOST_METRES) {
                return Math.max(0, -ground.lowest());
            }
        }
        return NO_GROUND;
    }
}
