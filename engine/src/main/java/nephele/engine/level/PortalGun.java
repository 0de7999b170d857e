package nephele.engine.level;

/**
 * A gun that shoots two linked portals; a level without one has no gun. Width and height are those of both apertures.
 *
 * @param rangeMetres the range of a shot
 * @param toFloor true if the portals slide down to floors for players with that aid
 */
public record PortalGun(
        @Written(absent = "1.2") @Range(min = 0.1, max = 100) double widthMetres,
        @Written(absent = "2.1") @Range(min = 0.1, max = 100) double heightMetres,
        @Written(absent = "\"arch\"") PortalShape shape,
        @Written(absent = "500") @Range(min = 1, max = 100_000) double rangeMetres,
        @Written(absent = "true") boolean toFloor) {
    /** Creates a gun whose portals slide down to floors. */
    public PortalGun(double widthMetres, double heightMetres, PortalShape shape, double rangeMetres) {
        this(widthMetres, heightMetres, shape, rangeMetres, true);
    }
}
