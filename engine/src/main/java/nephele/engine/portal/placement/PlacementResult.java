package nephele.engine.portal.placement;

import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.ground.GroundSeat;

/** The result of a shot; a value. The preview before the shot and the shot itself are the same query. */
public sealed interface PlacementResult {
    /**
     * A portal, wholly on its surface.
     *
     * @param slideMetres distance from the aimed point to its centre
     */
    record Fits(Portal portal, double slideMetres) implements PlacementResult {}

    /**
     * No portal.
     *
     * @param where the aimed point; the end of the range if nothing was hit
     * @param unevenMetres with {@link Refusal#NOT_FLAT}, greatest deviation of the ground under the aimed aperture from
     *     its nearest plane, otherwise 0
     */
    record Refused(Refusal reason, Vec3 where, double unevenMetres) implements PlacementResult {
        /** Accuracy with which the nearest plane is found. */
        private static final double MEASURED_MILLIMETRES = 0.02;

        public Refused(Refusal reason, Vec3 where) {
            this(reason, where, 0);
        }

        /** Returns a deviation in whole millimetres, rounded up, so that what is refused is more than what is allowed. */
        public static long millimetres(double unevenMetres) {
            long measured = (long) Math.ceil(1000 * unevenMetres - MEASURED_MILLIMETRES);
            return Math.max(measured, Math.round(1000 * GroundSeat.MOST_UNEVEN_METRES) + 1);
        }
    }
}
