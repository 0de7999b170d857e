package nephele.engine.level;

/**
 * The player can shoot two portals that lead to each other. Absent: no gun. The measures are those of both apertures.
 *
 * @param rangeMetres how far a shot flies
 */
public record PortalGun(
        @Written(absent = "1.2", min = 0.1, max = 100) double widthMetres,
        @Written(absent = "2.1", min = 0.1, max = 100) double heightMetres,
        @Written(absent = "\"arch\"") PortalShape shape,
        @Written(absent = "500", min = 1, max = 100_000) double rangeMetres) {}
