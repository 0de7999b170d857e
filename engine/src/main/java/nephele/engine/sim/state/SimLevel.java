package nephele.engine.sim.state;

import java.util.List;
import java.util.Objects;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.WorldState.Arrival;
import nephele.engine.sim.state.WorldState.ExitState;
import nephele.engine.sim.state.WorldState.FallState;
import nephele.engine.sim.state.WorldState.HeldBody;
import nephele.engine.sim.state.WorldState.TickTrace;
import org.joml.Vector3d;

/**
 * The part of a level that the simulation uses: the static geometry, and the initial portals and bodies.
 *
 * @param statics all static geometry
 * @param start where the player starts; {@code null} becomes the origin
 * @param portals the fixed ones
 * @param gun the placement of shot portals, {@code null} if the player has no gun
 * @param exits cylinders that end the level
 */
public record SimLevel(
        CollisionWorld statics, PlayerStart start, BodyTable bodies, Portals portals, Placement gun, List<Exit> exits) {
    private static final PlayerStart ORIGIN = new PlayerStart(Vec3.ZERO, 0, 0);
    private static final BodyTable NO_BODIES = new BodyTable(List.of());

    public SimLevel {
        start = start == null ? ORIGIN : start;
    }

    /** Returns the simulation's part of a level with its models placed. */
    public static SimLevel of(PlacedLevel placed) {
        return of(placed.level(), placed.statics());
    }

    /** Returns the simulation's part of a level without models. */
    public static SimLevel of(Level level) {
        return of(level, StaticShapes.of(level));
    }

    private static SimLevel of(Level level, StaticShapes statics) {
        return of(level, CollisionWorld.of(statics), gun(level, statics));
    }

    private static SimLevel of(Level level, CollisionWorld world, Placement gun) {
        return new SimLevel(world, level.player(), BodyTable.of(level), Portals.of(level), gun, level.exits());
    }

    private static Placement gun(Level level, StaticShapes statics) {
        return level.portalGun() == null
                ? null
                : new Placement(PlacementSurfaces.of(statics), Gun.of(level.portalGun()));
    }

    /**
     * Returns the simulation's part of an edited level; collision geometry is built anew only where it differs.
     *
     * @param before the level that this object was made of
     */
    public SimLevel edited(PlacedLevel before, PlacedLevel placed) {
        boolean isGunSame = before.statics() == placed.statics()
                && Objects.equals(before.level().portalGun(), placed.level().portalGun());
        return of(
                placed.level(),
                statics.edited(placed.statics()),
                isGunSame ? gun : gun(placed.level(), placed.statics()));
    }

    /** Returns a level of solids alone. */
    public static SimLevel of(CollisionWorld statics, PlayerStart start) {
        return of(statics, start, Portals.NONE);
    }

    /** Returns a level of solids and portals. */
    public static SimLevel of(CollisionWorld statics, PlayerStart start, Portals portals) {
        return new SimLevel(statics, start, NO_BODIES, portals, null, List.of());
    }

    /** Returns a player's start with its feet below a standing player's eye, as for a camera. */
    public static PlayerStart startBelow(Vec3 eye, double yawDegrees, double pitchDegrees) {
        var feet = new Vec3(eye.x(), eye.y() - Stance.STANDING.eyeMetres(), eye.z());
        return new PlayerStart(feet, yawDegrees, Math.max(-90, Math.min(90, pitchDegrees)));
    }

    /** Returns a start near another one in which the player overlaps no solid; the same one if there is none. */
    public PlayerStart freeStart(PlayerStart near) {
        Vec3 feet = near.feet();
        Vector3d centre = new Vector3d(feet.x(), feet.y() + Stance.STANDING.centreAboveFeet(), feet.z());
        Vector3d out = new Vector3d();
        boolean isFound = new Depenetration().find(statics, Stance.STANDING.shape(), centre, out);
        return isFound ? new PlayerStart(feet.plus(Vec3.of(out)), near.yawDegrees(), near.pitchDegrees()) : near;
    }

    /** Returns the world state at tick 0. */
    public WorldState begin(PortalWorld.Cache worlds) {
        ExitState exit = ExitState.start(exits);
        if (bodies.size() == 0 && portals.size() == 0) {
            return WorldState.NOTHING.with(exit);
        }
        Portals open = worlds.of(portals).portals();
        return new WorldState(
                bodies.start(),
                open,
                GunPortals.NONE,
                HeldBody.NOTHING,
                TickTrace.NONE,
                exit,
                FallState.NONE,
                Arrival.NONE);
    }
}
