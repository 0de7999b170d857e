package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;

/**
 * What the simulation takes from a level and what never changes, but for the portals to begin with.
 *
 * @param statics everything solid that never moves
 * @param start where the player begins
 * @param portals the fixed ones
 * @param gun {@code null}: the player has none
 */
public record SimLevel(CollisionWorld statics, PlayerStart start, Portals portals, PortalGun gun) {
    private static final PlayerStart ORIGIN = new PlayerStart(Vec3.ZERO, 0, 0);

    public SimLevel {
        start = start == null ? ORIGIN : start;
    }

    public static SimLevel of(Level level) {
        return new SimLevel(CollisionWorld.of(level), level.player(), Portals.of(level), level.portalGun());
    }

    /** Solids alone. */
    public static SimLevel of(CollisionWorld statics, PlayerStart start) {
        return new SimLevel(statics, start, Portals.NONE, null);
    }
}
