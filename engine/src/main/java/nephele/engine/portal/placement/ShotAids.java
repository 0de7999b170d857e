package nephele.engine.portal.placement;

/**
 * Aids of a shot: where its portal goes besides the legal place nearest to the aimed point.
 *
 * @param dropMetres greatest height above a floor from which a portal on a wall slides down to it; 0 for none
 * @param leastFloorY least upward component of the unit normal of a floor
 * @param turnRadians greatest angle by which a portal on a floor or ceiling turns to a right angle of its surface; 0 for
 *     none
 */
public record ShotAids(double dropMetres, double leastFloorY, double turnRadians) {
    public static final ShotAids NONE = new ShotAids(0, 1, 0);
}
