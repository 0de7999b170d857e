package nephele.engine.portal.placement;

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
