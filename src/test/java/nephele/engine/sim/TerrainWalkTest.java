package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import org.junit.jupiter.api.Test;

/** Players walk and bodies roll and sleep on terrains. Forward is −z. */
class TerrainWalkTest {
    private final TestAssets map;
    private final Terrain terrain;

    TerrainWalkTest() {
        map = TestTerrain.map(33, (column, row) -> row < 12 ? 0 : (int) (65535 * (row - 12) / 20.0));
        terrain = TestTerrain.said("hill", "map.r16");
    }

    private Simulation simulation(PlayerStart start, Body... bodies) {
        Level level = new TestLevel()
                .level()
                .with(start, null)
                .with(List.of(), List.of(), List.of(bodies))
                .withTerrains(List.of(terrain));
        return new Simulation(SimLevel.of(PlacedLevel.of(level, map)), SimSettings.DEFAULT);
    }

    private double ground(Vec3 at) {
        HeightField field = PlacedLevel.of(new TestLevel().level().withTerrains(List.of(terrain)), map)
                .statics()
                .ground()
                .get(0)
                .field();
        return HeightFieldSurface.y(field, at.x(), at.z());
    }

    /** The slope has 14 degrees; it is walked down at the speed of a slope, in contact all the time. */
    @Test
    void aPlayerWalksDownTheSlopeOntoTheFlat() {
        Simulation simulation = simulation(new PlayerStart(new Vec3(0.3, 9, 24), 0, 0));
        SimState state = simulation.start();
        for (int i = 0; i < 200; i++) {
            state = simulation.step(state, PlayerInput.NONE);
        }
        for (int i = 0; i < 1100; i++) {
            state = simulation.step(state, PlayerInput.FORWARD);
            assertTrue(state.player().isGrounded(), "tick " + i);
        }
        Vec3 feet = state.player().feet();
        assertTrue(feet.z() < -9, feet.toString());
        assertEquals(0, feet.y(), 1e-6);
    }

    @Test
    void aBallRollsDownAndACubeStaysAndSleeps() {
        Body ball = new Body.Sphere("ball", new Vec3(-5, 7, 16), 0.4, 5, null, 0.6, 0);
        Body cube = new Body.Box("cube", new Vec3(6.3, 6.4, 14.4), new Vec3(0.6, 0.6, 0.6), 5, null, 0.9, 0);
        Body onFlat = new Body.Box("flat", new Vec3(3.2, 0.7, -20), new Vec3(0.6, 0.6, 0.6), 5, null, 0.6, 0);
        Simulation simulation = simulation(new PlayerStart(new Vec3(20, 1, -20), 0, 0), ball, cube, onFlat);
        SimState state = simulation.start();
        for (int i = 0; i < 1000; i++) {
            state = simulation.step(state, PlayerInput.NONE);
        }
        BodyState rolled = state.world().bodies().state(0);
        assertTrue(rolled.centre().z() < 0, rolled.toString());
        assertEquals(ground(rolled.centre()) + 0.4, rolled.centre().y(), 0.01);
        BodyState still = state.world().bodies().state(1);
        assertEquals(14.4, still.centre().z(), 0.3);
        assertEquals(
                ground(still.centre()) + 0.3 / Math.cos(Math.atan(0.25)),
                still.centre().y(),
                0.01);
        BodyState flat = state.world().bodies().state(2);
        assertEquals(0.3, flat.centre().y(), 0.005);
        assertTrue(state.world().bodies().isAsleep(2), flat.toString());
    }
}
