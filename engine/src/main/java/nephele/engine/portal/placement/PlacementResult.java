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

    /** The reason why a shot makes no portal; the first one that applies. */
    public enum Refusal {
        /** The ray hits nothing. */
        NOTHING_HIT,
        /** The first surface is beyond the gun's range. */
        OUT_OF_RANGE,
        /** The first hit is on a dynamic object. */
        MOVING_SURFACE,
        /** The first surface permits no portal. */
        NOT_PORTALABLE,
        /** The ground of a terrain is more uneven under the aperture than a portal permits. */
        NOT_FLAT,
        /** The aperture would fit without the other portal. */
        OVERLAPS_OTHER,
        /** The surface has no place for the aperture at any distance. */
        TOO_SMALL,
        /** No place is within the slide distance, but there is one farther away, or too much surface to search. */
        EDGE,
        /** A body or player in the gun's old portals cannot be moved to its side of them. */
        OCCUPIED
    }
}
