package nephele.engine.portal.placement;

/** Why a shot makes no portal; the first that applies. */
public enum Refusal {
    /** Nothing at all lies that way. */
    NOTHING_HIT,
    /** The first surface lies beyond the gun's range. */
    OUT_OF_RANGE,
    /** The first thing hit moves. */
    MOVING_SURFACE,
    /** The author allows no portal on the first surface hit. */
    NOT_PORTALABLE,
    /** It would fit, were the other portal not there. */
    OVERLAPS_OTHER,
    /** The surface has no place for the aperture, however far it were moved. */
    TOO_SMALL,
    /** No place is as near to the aim as a portal slides, but there is one, or too much surface to look for one. */
    EDGE,
    /** What stands in the gun's old portals cannot be put on its side of them. */
    OCCUPIED
}
