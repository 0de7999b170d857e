package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import org.junit.jupiter.api.Test;

/** A body that has fallen out of the world returns to its place when that is free; nothing else changes. */
class BodyReturnTest {
    private static final Vec3 BACK = new Vec3(0, 0, 1);
    private static final SimSettings RETURNING = new SimSettings(120, List.of(Assist.BODY_RETURN));

    private static Lab ledge(SimSettings settings) {
        return new Lab()
                .box(-2, -1, -2, 2, 0, 2)
                .cube(new Vec3(0, 0.25, -1.5), 0.5, 10)
                .startAt(0, 0, 1, 0, 0)
                .with(settings);
    }

    /** Puts a body elsewhere, at rest. */
    private static void put(Lab lab, int body, Vec3 centre) {
        SimState state = lab.state();
        lab.set(state.with(state.world().with(state.world().bodies().with(body, BodyState.resting(centre)))));
    }

    private static void throwOff(Lab lab) {
        SimState state = lab.hold(PlayerInput.NONE, 0.2).state();
        BodyState thrown = state.world().bodies().state(0).moving(new Vec3(1, 2, -4), new Vec3(3, 2, 1));
        lab.set(state.with(state.world().with(state.world().bodies().with(0, thrown))));
    }

    @Test
    void whatIsThrownOffALedgeComesBackAtRest() {
        Lab lab = ledge(RETURNING);
        throwOff(lab);
        lab.hold(PlayerInput.NONE, 3);
        assertTrue(lab.body(0).y() < -20, "falls on: " + lab.body(0));
        double[] lowest = {0};
        lab.hold(
                PlayerInput.NONE,
                3,
                state -> lowest[0] = Math.min(
                        lowest[0], state.world().bodies().state(0).centre().y()));
        assertEquals(-1 - Simulation.FALL_METRES, lowest[0], 1, "where a player would start again");
        assertEquals(List.of(new TickEvent.BodyReturned(0)), lab.events());
        assertTrue(
                lab.body(0).minus(new Vec3(0, 0.25, -1.5)).length() < 2e-3,
                lab.body(0).toString());
        assertEquals(0, lab.state().world().bodies().state(0).velocity().length(), 1e-3);
        assertEquals(1, lab.state().world().bodies().state(0).orientation().w, 1e-6);
    }

    /** The rule holds where it is named alone: without it every state is what it was, with it until a body is lost. */
    @Test
    void aReplayThatDoesNotNameItRunsWithoutIt() {
        Lab with = ledge(RETURNING);
        Lab without = ledge(SimSettings.DEFAULT);
        throwOff(with);
        throwOff(without);
        assertEquals(
                without.hold(PlayerInput.NONE, 3).state().hash(),
                with.hold(PlayerInput.NONE, 3).state().hash());
        without.hold(PlayerInput.NONE, 3);
        assertTrue(without.body(0).y() < -100, without.body(0).toString());
        assertNotEquals(
                without.state().hash(), with.hold(PlayerInput.NONE, 3).state().hash());
    }

    /** A recording names the rule, and its replay repeats the return. */
    @Test
    void aRecordingNamesItAndRepeats() {
        Lab lab = new Lab()
                .box(-2, -1, -2, 2, 0, 2)
                .cube(new Vec3(3, 1, 0), 0.5, 10)
                .with(RETURNING);
        lab.hold(PlayerInput.NONE, 5);
        assertEquals(1, lab.events().size());
        var recorded = new Replay("room.json", RETURNING, null, List.of(new Replay.Run(600, 0, 0, 0, 0, List.of())));
        String text = recorded.write();
        assertTrue(text.contains("\"body-return\""), text);
        var read = Replay.read("room.json", text.getBytes(StandardCharsets.UTF_8));
        var last = new SimState[1];
        var again = new Simulation(SimLevel.of(lab.level()), read.settings());
        read.play(again, state -> last[0] = state);
        assertEquals(lab.state().hash(), last[0].hash());
    }

    @Test
    void itWaitsUntilThePlayerHasLeftThePlace() {
        Lab lab = ledge(RETURNING);
        put(lab, 0, new Vec3(0, -60, 0));
        lab.set(lab.state().withPlayer(lab.player().withFeet(new Vec3(0, 0, -1.5))));
        lab.hold(PlayerInput.NONE, 1);
        assertTrue(lab.body(0).y() < -60 && lab.events().isEmpty(), "the player stands there: " + lab.body(0));
        lab.hold(PlayerInput.NONE.walking(-100, 0), 0.6);
        assertEquals(List.of(new TickEvent.BodyReturned(0)), lab.events());
    }

    @Test
    void itWaitsUntilAnotherBodyHasLeftThePlace() {
        Lab lab = ledge(RETURNING).cube(new Vec3(1.5, 0.25, 0), 0.5, 10);
        put(lab, 0, new Vec3(0, -60, 0));
        put(lab, 1, new Vec3(0.2, 0.25, -1.4));
        lab.hold(PlayerInput.NONE, 1);
        assertTrue(lab.body(0).y() < -60 && lab.events().isEmpty(), lab.body(0).toString());
        put(lab, 1, new Vec3(1.5, 0.25, 0));
        lab.tick(PlayerInput.NONE);
        assertEquals(List.of(new TickEvent.BodyReturned(0)), lab.events());
    }

    /** What stands in a portal is in the place before its exit with the part that has gone through. */
    @Test
    void itWaitsForWhatReachesThereThroughAPortal() {
        for (boolean isPlayer : new boolean[] {true, false}) {
            Lab lab = Lab.hall()
                    .pair(new Vec3(0, 1.05, -8), BACK, new Vec3(4, 1.05, -8), BACK)
                    .cube(new Vec3(4, 0.25, -7.7), 0.5, 10)
                    .cube(new Vec3(-5, 0.25, 3), 0.5, 10)
                    .startAt(0, 0, 5, 0, 0)
                    .with(RETURNING);
            put(lab, 0, new Vec3(0, -60, 0));
            if (isPlayer) {
                lab.set(lab.state().withPlayer(lab.player().withFeet(new Vec3(0, 0, -7.9))));
            } else {
                put(lab, 1, new Vec3(0, 0.25, -7.9));
            }
            lab.tick(PlayerInput.NONE);
            assertFalse(lab.body(0).y() > 0, "something reaches there: " + lab.body(0));
            if (isPlayer) {
                lab.set(lab.state().withPlayer(lab.player().withFeet(new Vec3(0, 0, 5))));
            } else {
                put(lab, 1, new Vec3(0, 0.25, 0));
            }
            lab.tick(PlayerInput.NONE);
            assertEquals(List.of(new TickEvent.BodyReturned(0)), lab.events());
        }
    }
}
