package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import org.junit.jupiter.api.Test;

/** A body with a motion that is not finite is frozen, and counted once in the state. */
class BodyFaultTest {
    private static final String LEVEL = "{\"format\": \"nephele-level\", \"version\": 1,"
            + "\"solids\": [{\"id\": \"f\", \"kind\": \"box\", \"centre\": [0, -1, 0], \"size\": [50, 2, 50]}],"
            + "\"bodies\": [{\"id\": \"b\", \"kind\": \"box\", \"centre\": [3, 2, 0], \"size\": [1, 1, 1],"
            + " \"massKilograms\": 5}]}";

    @Test
    void frozenBodyIsAFault() throws Exception {
        var level = LevelJson.read("fault.json", LEVEL.getBytes(java.nio.charset.StandardCharsets.UTF_8));
        var simulation = new Simulation(SimLevel.of(level), SimSettings.DEFAULT);
        SimState state = simulation.start();
        var bodies = state.world().bodies();
        BodyState wrong = bodies.state(0).moving(new Vec3(Double.NaN, 0, 0), Vec3.ZERO);
        state = state.with(state.world().with(bodies.with(0, wrong)));
        for (int tick = 0; tick < 5; tick++) {
            state = simulation.step(state, PlayerInput.NONE);
        }
        assertTrue(state.world().bodies().isFrozen(0));
        assertEquals(1, state.faults());
    }
}
