package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState.FallState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** With the assist a fall out of the level leads back to where the player last stood. */
final class SafeReturnTest {
    private static final PlayerInput RIGHT = PlayerInput.NONE.walking(0, 100);
    private static final PlayerInput AHEAD = PlayerInput.FORWARD;

    private static SimSettings settings(int ticksPerSecond) {
        return new SimSettings(ticksPerSecond, List.of(Assist.SAFE_RETURN));
    }

    /** A platform of 20 m by 4 m and 1 m thick; the player starts at its middle. */
    private static Lab platform() {
        return new Lab().box(-10, -1, -2, 10, 0, 2).startAt(0, 0, 0, 0, 0);
    }

    private static Lab helped() {
        return platform().with(settings(120));
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 60, 120, 1000})
    void whoFallsIsBackWithinHalfASecondWhereItStood(int rate) {
        Lab lab = platform().with(settings(rate));
        lab.hold(RIGHT, 1).hold(PlayerInput.NONE, 1.2);
        Vec3 stood = lab.player().feet();
        assertTrue(stood.x() > 3, stood::toString);
        lab.hold(AHEAD, 0.4);
        while (lab.events().isEmpty()) {
            lab.tick(AHEAD);
        }
        assertTrue(lab.player().feet().y() > -4, "the fall is noticed at once: " + lab.player());
        long fell = lab.state().tick();
        while (lab.events().size() == 1) {
            lab.tick(PlayerInput.NONE);
        }
        assertEquals(List.of(TickEvent.Plain.PLAYER_FELL, TickEvent.Plain.PLAYER_RETURNED), lab.events());
        double dark = (lab.state().tick() - fell) / (double) rate;
        assertTrue(dark <= FallState.FADE_SECONDS, "fades for " + dark + " s");
        assertEquals(stood, lab.player().feet());
        assertEquals(Vec3.ZERO, lab.player().velocity());
        lab.hold(PlayerInput.NONE, 1);
        assertEquals(stood, lab.player().feet());
        assertTrue(lab.player().isGrounded());
    }

    @Test
    void withoutTheAssistTheLevelsStartIsWhereAFallEnds() {
        Lab lab = platform();
        Vec3 start = lab.player().feet();
        lab.hold(RIGHT, 1).hold(PlayerInput.NONE, 1.2).hold(AHEAD, 1).hold(PlayerInput.NONE, 5);
        assertEquals(start, lab.player().feet());
        assertEquals(List.of(), lab.events());
    }

    /** A run that never stops is not lost either: it continues half a second to a second before its end. */
    @Test
    void whoNeverStoppedIsBackWhereItHadGroundForHalfASecond() {
        Lab lab = helped();
        while (!lab.events().contains(TickEvent.Plain.PLAYER_RETURNED)) {
            lab.tick(RIGHT);
        }
        Vec3 feet = lab.player().feet();
        assertTrue(feet.x() > 5.5 && feet.x() < 8.5, feet::toString);
    }

    /** Half a second in the air, or on a body, is no ground; nor is the place before an open portal. */
    @Test
    void onlyGroundThatStaysCounts() {
        Lab jumping = helped();
        for (int i = 0; i < 200; i++) {
            jumping.tick(RIGHT.holding(Action.JUMP)).tick(RIGHT);
        }
        Vec3 feet = jumping.hold(PlayerInput.NONE, 2).player().feet();
        assertEquals(0, feet.x(), 0.5, "none of its short landings");

        Lab onBody = helped().cube(new Vec3(3, 0.5, 0), 1, 200);
        Vec3 stood = onBody.hold(PlayerInput.NONE, 1.2).player().feet();
        onBody.set(onBody.state().withPlayer(onBody.player().withFeet(new Vec3(3, 1, 0))));
        assertEquals(1, onBody.hold(PlayerInput.NONE, 2).player().feet().y(), 1e-3, "stands on the cube");
        assertEquals(
                stood, onBody.hold(AHEAD, 1).hold(PlayerInput.NONE, 2).player().feet());

        Lab atPortal = new Lab()
                .box(-10, -1, -2, 10, 0, 2)
                .box(4, 0, -2, 5, 3, 2)
                .box(-6, 0, -2, -5, 3, 2)
                .pair(new Vec3(4, 1.05, 0), new Vec3(-1, 0, 0), new Vec3(-5, 1.05, 0), new Vec3(1, 0, 0))
                .with(settings(120));
        atPortal.hold(PlayerInput.NONE, 1).hold(RIGHT, 0.98).hold(PlayerInput.NONE, 2);
        assertEquals(3.85, atPortal.player().feet().x(), 0.15, "stands in the portal");
        atPortal.hold(AHEAD, 1).hold(PlayerInput.NONE, 2);
        assertTrue(atPortal.player().feet().x() < 3.65, atPortal.player()::toString);
    }

    @Test
    void whoFallsAtOnceIsBackAtTheStart() {
        Lab lab = new Lab().box(-10, -1, -2, 10, 0, 2).startAt(0, 0, -1.9, 0, 0).with(settings(120));
        Vec3 start = lab.player().feet();
        lab.hold(AHEAD, 0.5).hold(PlayerInput.NONE, 2);
        assertTrue(lab.events().contains(TickEvent.Plain.PLAYER_RETURNED));
        assertEquals(start, lab.player().feet());
    }

    /** A body that has come into the place since is pushed out of it, not flung. */
    @Test
    void aBodyInThePlaceIsPushedOutOfIt() {
        Lab lab = helped().cube(new Vec3(6, 0.3, 0), 0.6, 20).hold(PlayerInput.NONE, 1.2);
        lab.hold(AHEAD, 1);
        BodyState there = BodyState.resting(new Vec3(0.05, 0.3, 0));
        lab.set(lab.state()
                .with(lab.state().world().with(lab.state().world().bodies().with(0, there))));
        double[] most = new double[1];
        lab.hold(PlayerInput.NONE, 4, state -> {
            boolean isBack = state.world().fall().returnedTick() > 0;
            double body = state.world().bodies().state(0).velocity().length();
            most[0] = isBack
                    ? Math.max(most[0], Math.max(body, state.player().velocity().length()))
                    : 0;
        });
        assertTrue(lab.events().contains(TickEvent.Plain.PLAYER_RETURNED));
        assertTrue(most[0] < 3, "flung at " + most[0]);
        assertTrue(lab.player().feet().y() > -0.01, lab.player()::toString);
        assertTrue(lab.body(0).y() > 0.29, "the cube at " + lab.body(0));
    }

    /** The picture is black when the player is put back, as always before the fall and a quarter of a second after. */
    @Test
    void thePictureIsBlackAtTheReturnAndOnlyAroundIt() {
        Lab lab = helped().hold(PlayerInput.NONE, 1);
        boolean[] black = new boolean[1];
        double[] before = {0};
        lab.hold(AHEAD, 3, state -> {
            double dark = darkness(state);
            assertTrue(Math.abs(dark - before[0]) <= 1 / 30.0 + 1e-9, "no leap of the fade");
            before[0] = dark;
            boolean returned = state.world().trace().events().contains(TickEvent.Plain.PLAYER_RETURNED);
            black[0] |= returned && dark == 1;
            assertTrue(!returned || dark == 1);
        });
        assertTrue(black[0]);
        assertEquals(0, darkness(helped().state()));
        assertEquals(0, darkness(platform().state()));
        assertEquals(0, darkness(lab.hold(PlayerInput.NONE, 1).state()));
    }

    private static double darkness(SimState state) {
        return state.world().fall().darkness(state.tick(), 120);
    }

    /** The memory is part of the state: two states that differ in it alone differ in their hashes. */
    @Test
    void theMemoryIsHashedWithTheAssistAlone() {
        SimState with = helped().hold(PlayerInput.NONE, 1).state();
        SimState without = platform().hold(PlayerInput.NONE, 1).state();
        assertEquals(with.with(with.world().with(FallState.NONE)).hash(), without.hash());
        FallState fall = with.world().fall();
        for (FallState other : List.of(
                fall.fell(3), fall.returned(3), fall.withCandidate(null, 0), fall.confirmed(), FallState.NONE)) {
            assertNotEquals(with.hash(), with.with(with.world().with(other)).hash());
        }
    }
}
