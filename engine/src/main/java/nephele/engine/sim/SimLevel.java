package nephele.engine.sim;

import java.util.List;
import java.util.Objects;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.Surfaces;

/**
 * What the simulation takes from a level, and what never changes but for the portals and bodies to begin with.
 *
 * @param statics everything solid that never moves
 * @param start where the player begins
 * @param portals the fixed ones
 * @param gun {@code null}: the player has none
 */
public record SimLevel(CollisionWorld statics, PlayerStart start, BodyTable bodies, Portals portals, Placement gun) {
    private static final PlayerStart ORIGIN = new PlayerStart(Vec3.ZERO, 0, 0);
    private static final BodyTable NO_BODIES = new BodyTable(List.of());

    public SimLevel {
        start = start == null ? ORIGIN : start;
    }

    public static SimLevel of(PlacedLevel placed) {
        return of(placed.level(), placed.statics());
    }

    /** Of a level without models. */
    public static SimLevel of(Level level) {
        return of(level, StaticShapes.of(level));
    }

    private static SimLevel of(Level level, StaticShapes statics) {
        return of(level, CollisionWorld.of(statics), gun(level, statics));
    }

    private static SimLevel of(Level level, CollisionWorld world, Placement gun) {
        return new SimLevel(world, level.player(), BodyTable.of(level), Portals.of(level), gun);
    }

    private static Placement gun(Level level, StaticShapes statics) {
        return level.portalGun() == null ? null : new Placement(Surfaces.of(statics), Gun.of(level.portalGun()));
    }

    /**
     * That of an edited level; what is solid is built anew only where it differs.
     *
     * @param before what this is of
     */
    public SimLevel edited(PlacedLevel before, PlacedLevel placed) {
        boolean isGunSame = before.statics() == placed.statics()
                && Objects.equals(before.level().portalGun(), placed.level().portalGun());
        return of(
                placed.level(),
                statics.edited(placed.statics()),
                isGunSame ? gun : gun(placed.level(), placed.statics()));
    }

    /** Solids alone. */
    public static SimLevel of(CollisionWorld statics, PlayerStart start) {
        return of(statics, start, Portals.NONE);
    }

    /** Solids and portals. */
    public static SimLevel of(CollisionWorld statics, PlayerStart start, Portals portals) {
        return new SimLevel(statics, start, NO_BODIES, portals, null);
    }

    /** What can change, as it is at tick 0. */
    Changeable begin(Spaces spaces) {
        if (bodies.size() == 0 && portals.size() == 0) {
            return Changeable.NOTHING;
        }
        Portals open = spaces.of(portals).portals();
        return new Changeable(bodies.start(), open, Shots.NONE, Holding.NOTHING, TickTrace.NONE);
    }
}
