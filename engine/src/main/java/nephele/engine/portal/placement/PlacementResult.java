package nephele.engine.portal.placement;

import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;

/** What a shot would do. A value; the ghost before the shot and the shot itself are the same query. */
public sealed interface PlacementResult {
    /**
     * A portal, wholly on its surface.
     *
     * @param slideMetres from the aimed point to its centre
     */
    record Fits(Portal portal, double slideMetres) implements PlacementResult {}

    /** @param where the aimed point; the end of the range when nothing was hit */
    record Refused(Refusal reason, Vec3 where) implements PlacementResult {}
}
