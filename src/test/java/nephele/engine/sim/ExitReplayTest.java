package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState;
import nephele.engine.sim.state.WorldState.ExitState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The first tick with the player's centre in an exit ends the level, and the simulation goes on. */
class ExitReplayTest {
    private static final Exit AHEAD = new Exit("ahead", new Vec3(0, 0, -3), 0.5, 2);
    private static final Exit BEYOND = new Exit("beyond", new Vec3(0, 0, -6), 1, 2);

    private static Level level(Exit... exits) {
        TestLevel level = new TestLevel().box(null, new Vec3(0, -0.5, 0), new Vec3(40, 1, 40));
        for (Exit exit : exits) {
            level.exit(exit);
        }
        return level.level();
    }

    private static List<SimState> walk(Level level, PlayerInput input, int ticks) {
        Simulation simulation = new Simulation(level, SimSettings.DEFAULT);
        List<SimState> states = new ArrayList<>(List.of(simulation.start()));
        for (int i = 0; i < ticks; i++) {
            states.add(simulation.step(states.get(i), input));
        }
        return states;
    }

    @Test
    void theFirstTickInsideEndsTheLevelOnce() {
        List<SimState> states = walk(level(AHEAD, BEYOND), PlayerInput.FORWARD, 240);
        int end = 0;
        while (states.get(end).player().centre().z() > -2.5) {
            assertEquals(ExitState.OPEN, states.get(end).world().exit());
            end++;
        }
        assertEquals(new ExitState(0, end), states.get(end).world().exit());
        assertEquals(
                List.of(new TickEvent.ExitReached(0)),
                states.get(end).world().trace().events());
        for (SimState later : states.subList(end + 1, states.size())) {
            assertEquals(new ExitState(0, end), later.world().exit());
            assertEquals(List.of(), later.world().trace().events());
        }
        assertTrue(states.get(240).player().feet().z() < -7, "walks on, through the second exit");
    }

    @Test
    void onlyLevelsWithExitsHashThem() {
        List<SimState> without = walk(level(), PlayerInput.FORWARD, 120);
        List<SimState> with = walk(level(AHEAD), PlayerInput.FORWARD, 120);
        assertEquals(WorldState.NOTHING, without.get(120).world());
        for (int i = 0; i <= 120; i++) {
            assertEquals(without.get(i).player(), with.get(i).player());
            assertNotEquals(without.get(i).hash(), with.get(i).hash());
        }
        SimState ended = with.get(120);
        assertTrue(ended.world().exit().isReached());
        assertNotEquals(
                ended.hash(), ended.with(ended.world().with(ExitState.OPEN)).hash());
    }

    /** The centre of a crouching player is lower than that of a standing one. */
    @Test
    void theCentreDecidesNotTheFeet() {
        Level low = level(new Exit("low", new Vec3(0, 0, -1), 0.5, 0.8));
        assertFalse(walk(low, PlayerInput.FORWARD, 120).get(120).world().exit().isReached());
        assertTrue(walk(low, PlayerInput.FORWARD.holding(Action.CROUCH), 120)
                .get(120)
                .world()
                .exit()
                .isReached());
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 0, true",
        "0.5, 0, 0, true",
        "0.25, 1, 0.25, true",
        "0, 2, -0.5, true",
        "0.5000001, 1, 0, false",
        "0.36, 1, 0.36, false",
        "0, -1e-9, 0, false",
        "0, 2.0000001, 0, false"
    })
    void anExitHoldsItsBaseTopAndSide(double x, double y, double z, boolean inside) {
        Exit exit = new Exit("e", new Vec3(8, 4, 2), 0.5, 2);
        assertEquals(inside, exit.contains(new Vec3(8 + x, 4 + y, 2 + z)));
    }
}
