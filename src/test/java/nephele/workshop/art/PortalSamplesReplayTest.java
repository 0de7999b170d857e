package nephele.workshop.art;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.terrain.TerrainField;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The sample levels of portals keep their state when they run without input for a few seconds. */
class PortalSamplesReplayTest {
    private static final int TICKS = 360;

    private static Level level(String name) {
        return LevelFile.load(Path.of("levels/samples", name + ".json")).level();
    }

    private static SimState left(Level level) {
        Simulation simulation = new Simulation(level, SimSettings.DEFAULT);
        SimState state = simulation.start();
        for (int tick = 0; tick < TICKS; tick++) {
            state = simulation.step(state, PlayerInput.NONE);
        }
        return state;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "facing-portals",
                "floor-to-ceiling",
                "slanted-walls",
                "edge-to-edge",
                "hall-of-mirrors",
                "mirror",
                "portal-on-soup",
                "straddling-cube"
            })
    void portalsStayOpenAndNobodyIsHurt(String name) {
        Level level = level(name);
        SimState end = left(level);
        assertEquals(0, end.faults());
        assertTrue(!level.portals().isEmpty()
                && level.portals().size() == end.world().portals().size());
        for (int i = 0; i < level.portals().size(); i++) {
            assertTrue(end.world().portals().isOpen(i), level.portals().get(i).id() + " is closed");
        }
        assertEquals(level.player().feet().y(), end.player().feet().y(), 0.01);
    }

    /** The door of the valley is crossed at a walk, and the ground of the canyon carries whoever came through it. */
    @Test
    void aWalkGoesFromOneTerrainToTheOther() {
        OpenedLevel opened = new LevelName("levels/samples/terrain-portals.json").open();
        Terrain canyon = opened.level().terrains().get(1);
        Simulation simulation = new Simulation(SimLevel.of(opened.placed()), SimSettings.DEFAULT);
        SimState state = simulation.start();
        for (int tick = 0; tick < 2 * TICKS; tick++) {
            state = simulation.step(state, PlayerInput.FORWARD);
        }
        Vec3 feet = state.player().feet();
        assertEquals(0, state.faults());
        assertEquals(canyon.centre().x(), feet.x(), 2);
        assertTrue(feet.z() < 38, "beyond the plinth: " + feet);
        HeightField ground =
                TerrainField.of(canyon, opened.assets().decoded(canyon.heightMap(), HeightMap.class, HeightMap::read));
        assertEquals(HeightFieldSurface.y(ground, feet.x(), feet.z()), feet.y(), 0.1);
    }

    /** The cubes are half in one alcove and half in the other, and neither sinks, slides nor is pushed out. */
    @Test
    void straddlingCubesLieStill() {
        Level level = level("straddling-cube");
        SimState end = left(level);
        for (int i = 0; i < level.bodies().size(); i++) {
            Body body = level.bodies().get(i);
            Vector3d centre = end.world().bodies().centre(i, new Vector3d());
            assertEquals(0, centre.distance(body.centre().toVector()), 2e-3, body.id());
        }
    }

    /** The ball and the crate never land: after three seconds their speed is that of a free fall. */
    @Test
    void whatFallsFromFloorToCeilingFallsForEver() {
        SimState end = left(level("floor-to-ceiling"));
        for (int i = 0; i < 2; i++) {
            double speed = end.world().bodies().state(i).velocity().y();
            assertEquals(-9.81 * TICKS / 120, speed, 1e-6);
        }
    }
}
