package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleBinaryOperator;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;

/**
 * A terrain of 24 m that takes portals, with heights by a function of x and z, a portalable wall at z = −8, and a player
 * with a gun. With no heights, a floor instead.
 */
final class GroundCourse {
    private static final int SIDE = 121;
    private static final double RANGE_METRES = 8;

    final List<TickEvent> events = new ArrayList<>();
    final Simulation simulation;
    SimState state;
    private final HeightField field;

    GroundCourse(DoubleBinaryOperator heights, Vec3 feet, Body... bodies) {
        List<Solid> solids = new ArrayList<>();
        solids.add(box("wall", new Vec3(0, 4, -8.5), new Vec3(24, 20, 1)));
        if (heights == null) {
            solids.add(box("floor", new Vec3(0, -0.5, 0), new Vec3(24, 1, 24)));
        }
        Level level = new TestLevel()
                .level()
                .with(new PlayerStart(feet, 0, 0), new PortalGun(1.2, 2.1, PortalShape.ARCH, 500))
                .with(List.of(), solids, List.of(bodies));
        var map = TestTerrain.map(
                SIDE,
                (column, row) -> heights == null
                        ? 0
                        : (int) Math.round(65535
                                * (0.5 + heights.applyAsDouble(0.2 * column - 12, 0.2 * row - 12) / RANGE_METRES)));
        if (heights != null) {
            level = level.withTerrains(List.of(new Terrain(
                    "ground",
                    "map.r16",
                    Vec3.ZERO,
                    new Terrain.Sides(24, 24),
                    new Terrain.HeightRange(-RANGE_METRES / 2, RANGE_METRES / 2),
                    List.of(),
                    true)));
        }
        PlacedLevel placed = PlacedLevel.of(level, map);
        field = heights == null ? null : placed.statics().ground().get(0).field();
        simulation = new Simulation(SimLevel.of(placed), SimSettings.DEFAULT);
        state = simulation.start();
    }

    /** Returns the height of the terrain above or below a point. */
    double ground(Vec3 at) {
        return HeightFieldSurface.y(field, at.x(), at.z());
    }

    private static Solid box(String id, Vec3 centre, Vec3 size) {
        return new Solid.Box(id, null, true, null, centre, size, Map.of());
    }

    GroundCourse tick(PlayerInput input) {
        state = simulation.step(state, input);
        events.addAll(state.world().trace().events());
        return this;
    }

    GroundCourse hold(PlayerInput input, double seconds) {
        for (int i = 0; i < 120 * seconds; i++) {
            tick(input);
        }
        return this;
    }

    GroundCourse press(Action action) {
        return tick(PlayerInput.NONE.holding(action)).tick(PlayerInput.NONE);
    }

    GroundCourse turn(double leftDegrees, double upDegrees) {
        return tick(PlayerInput.NONE.turning((int) Math.round(1000 * leftDegrees), (int) Math.round(1000 * upDegrees)));
    }
}
