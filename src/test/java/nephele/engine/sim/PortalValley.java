package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import java.util.Map;
import nephele.engine.collision.PortalWorld;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.ShotRay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;

/**
 * A valley of bumpy ground, 32 m square: flat for |z| < 2, with slopes that rise to the north (−z) and to the south, and
 * a wall that faces east (+x) at x = −9.
 */
final class PortalValley {
    private static final double BUMP_METRES = 0.007;
    private static final double HALF = 16;
    private static final double CELL = 0.2;
    private static final double RANGE_METRES = 30;
    private static final double WALL_X = -9;
    private static final Gun GUN = new Gun(Aperture.of(PortalShape.ARCH, 1.2, 2.1), 200, 0.75);

    final Simulation simulation;
    SimState state;
    private final HeightField field;
    private final Placement placement;
    private final SimLevel level;

    PortalValley(double northDegrees, double southDegrees, List<Assist> assists, Body... bodies) {
        int side = 1 + (int) Math.round(2 * HALF / CELL);
        Terrain ground = new Terrain(
                "ground",
                "map.r16",
                Vec3.ZERO,
                new Terrain.Sides(2 * HALF, 2 * HALF),
                new Terrain.HeightRange(-1, RANGE_METRES - 1),
                List.of(),
                true);
        var map = TestTerrain.map(side, (column, row) -> (int) Math.round(65535
                * (1 + height(CELL * column - HALF, CELL * row - HALF, northDegrees, southDegrees))
                / RANGE_METRES));
        Solid wall =
                new Solid.Box("wall", null, true, null, new Vec3(WALL_X - 0.5, 4, 0), new Vec3(1, 20, 30), Map.of());
        Level said = new TestLevel()
                .level()
                .with(new PlayerStart(new Vec3(6, 0.2, 0), 0, 0), null)
                .with(List.of(), List.of(wall), List.of(bodies))
                .withTerrains(List.of(ground));
        PlacedLevel placed = PlacedLevel.of(said, map);
        field = placed.statics().ground().get(0).field();
        placement = new Placement(PlacementSurfaces.of(placed.statics()), GUN);
        level = SimLevel.of(placed);
        simulation = new Simulation(level, new SimSettings(120, assists));
        state = simulation.start();
    }

    private static double height(double x, double z, double northDegrees, double southDegrees) {
        double steep = Math.toRadians(z < 0 ? northDegrees : southDegrees);
        double bump = BUMP_METRES * Math.sin(7 * x) * Math.cos(5 * z) / Math.cos(steep);
        return bump + Math.tan(steep) * Math.max(0, Math.min(Math.abs(z), 13) - 2);
    }

    /** Returns the portal that a shot at the slope to the north makes, from an eye that looks down at it. */
    Portal north() {
        return north(-5);
    }

    /** Returns it at another place: at z = −12 it is just below the crest, beyond which the ground is level. */
    Portal north(double z) {
        return shot("north", new Vec3(0, 0, z), Basis.ofYawPitch(0.3, -1.2));
    }

    Portal south() {
        return shot("south", new Vec3(1, 0, 5), Basis.ofYawPitch(Math.PI - 0.4, -1.2));
    }

    Portal wall() {
        return shot("wall", new Vec3(WALL_X, 1.25, 0), Basis.ofYawPitch(Math.PI / 2, 0));
    }

    /** Returns the portal of a shot at a point; points that are not on the wall are moved onto the ground below or above. */
    private Portal shot(String id, Vec3 at, Basis view) {
        Vec3 aimed = at.x() == WALL_X ? at : new Vec3(at.x(), ground(at), at.z());
        Vec3 eye = aimed.addScaled(2, view.back());
        PlacementResult result = placement.place(id, new ShotRay(eye, view), List.of(), Obstacles.NONE);
        return assertInstanceOf(PlacementResult.Fits.class, result, result::toString)
                .portal();
    }

    /** Returns the height of the ground above or below a point. */
    double ground(Vec3 at) {
        return HeightFieldSurface.y(field, at.x(), at.z());
    }

    /** Opens a pair. */
    PortalValley open(Portal a, Portal b) {
        Portals pair = new Portals(List.of(a, b), List.of(1, 0));
        state = state.with(state.world().with(pair, GunPortals.NONE));
        return this;
    }

    PortalWorld space() {
        return PortalWorld.of(level.statics(), state.world().portals());
    }

    PortalValley tick(PlayerInput input) {
        state = simulation.step(state, input);
        return this;
    }
}
