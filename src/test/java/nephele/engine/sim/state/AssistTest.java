package nephele.engine.sim.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Assists;
import nephele.engine.sim.Lab;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.WorldState.Arrival;
import nephele.engine.sim.state.WorldState.FallState;
import org.junit.jupiter.api.Test;

/** Each assist has its effect, and without it the effect is absent. */
final class AssistTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 DOWN = new Vec3(0, -1, 0);
    private static final Vec3 BACK = new Vec3(0, 0, 1);

    private static SimSettings with(Assist... assists) {
        return new SimSettings(120, List.of(assists));
    }

    /** A wall portal ahead, entered at walking speed, leads out of a floor portal. */
    private static Lab wallToFloor(SimSettings settings) {
        return Lab.hall()
                .pair(new Vec3(0, 1.05, -8), BACK, new Vec3(4, 0, 3), UP)
                .startAt(0, 0, -6, 0, 0)
                .with(settings);
    }

    private static long crossings(Lab lab, int forwardPercent, double seconds) {
        long[] count = new long[1];
        lab.hold(
                PlayerInput.NONE.walking(forwardPercent, 0),
                seconds,
                state -> count[0] += state.world().trace().playerCrossed().length());
        return count[0];
    }

    /**
     * With the assist, a player that leaves a floor portal at walking speed lands on the rim and does not fall back.
     */
    @Test
    void outOfAFloorAtWalkingSpeedOneLandsOnTheRim() {
        for (int percent : new int[] {100, 60, 30}) {
            Lab helped = wallToFloor(with(Assist.FLOOR_EXIT_SPEED));
            assertEquals(1, crossings(helped, percent, 1 + 150.0 / percent));
            assertTrue(helped.player().isGrounded(), helped.player().toString());
            assertEquals(0, helped.player().feet().y(), 1e-6);
            assertTrue(helped.player().feet().z() > 4, helped.player().toString());
        }
        Lab alone = wallToFloor(with());
        assertTrue(crossings(alone, 30, 6) > 1, "falls back: " + alone.player());
    }

    @Test
    void theExitSpeedIsTheLeast() {
        Lab lab = wallToFloor(with(Assist.FLOOR_EXIT_SPEED));
        double[] speed = new double[1];
        lab.hold(PlayerInput.FORWARD, 1, state -> {
            if (state.world().trace().playerCrossed().length() > 0) {
                speed[0] = state.player().velocity().y();
            }
        });
        assertEquals(Assists.MIN_FLOOR_EXIT_METRES_PER_SECOND, speed[0], 1e-12);
    }

    /** An endless fall has exactly the cap's speed with the cap, and more without it. */
    @Test
    void nothingIsFasterThanTheCap() {
        for (boolean capped : new boolean[] {true, false}) {
            Lab lab = Lab.hall()
                    .pair(new Vec3(0, 0, 0), UP, new Vec3(0, 6, 0), DOWN)
                    .startAt(0, 3, 0, 0, 0)
                    .with(capped ? with(Assist.SPEED_CAP) : with())
                    .hold(PlayerInput.NONE, 8);
            double speed = -lab.player().velocity().y();
            assertEquals(capped ? Assists.MAX_METRES_PER_SECOND : 9.81 * 8, speed, 1e-6);
        }
    }

    /**
     * A player that falls beside a floor portal and looks at it enters it with the funnel, and lands on the floor
     * without it or with a key held.
     */
    @Test
    void aFallIsLedIntoThePortalThatIsLookedAt() {
        for (double aside : new double[] {0, 0.7, 1.2, -1.2}) {
            assertTrue(falls(aside, -89, with(Assist.FUNNEL), PlayerInput.NONE), "led from " + aside);
        }
        assertFalse(falls(1.2, -89, with(), PlayerInput.NONE));
        assertFalse(falls(1.2, 0, with(Assist.FUNNEL), PlayerInput.NONE));
        assertFalse(falls(1.2, -89, with(Assist.FUNNEL), PlayerInput.NONE.walking(0, 1)));
        assertFalse(falls(2.5, -89, with(Assist.FUNNEL), PlayerInput.NONE));
    }

    /** In an endless fall between floor and ceiling the funnel damps the lateral sway to zero. */
    @Test
    void theFunnelCalms() {
        Lab lab = Lab.hall()
                .pair(new Vec3(0, 0, 0), UP, new Vec3(0, 6, 0), DOWN)
                .startAt(0.5, 3, 0.2, 0, -89)
                .with(with(Assist.FUNNEL))
                .hold(PlayerInput.NONE, 8);
        assertEquals(-9.81 * 8, lab.player().velocity().y(), 1e-6);
        assertEquals(0, lab.player().feet().x(), 1e-6);
        assertEquals(0, lab.player().velocity().x(), 1e-6);
    }

    private static boolean falls(double aside, double pitchDegrees, SimSettings settings, PlayerInput input) {
        Lab lab = Lab.hall()
                .pair(new Vec3(0, 0, 0), UP, new Vec3(-8, 3, 0), new Vec3(1, 0, 0))
                .startAt(aside, 4, 0, 0, pitchDegrees)
                .with(settings);
        boolean[] crossed = new boolean[1];
        lab.hold(
                input,
                1.2,
                state -> crossed[0] |= state.world().trace().playerCrossed().length() > 0);
        return crossed[0];
    }

    /** Without portals and bodies the assists change no bit of the state but their own memory. */
    @Test
    void assistsChangeNothingElse() {
        PlayerInput running = PlayerInput.FORWARD.holding(Action.RUN).holding(Action.JUMP);
        Lab plain = Lab.hall().hold(running, 2);
        SimState helped =
                Lab.hall().with(with(Assist.values())).hold(running, 2).state();
        assertEquals(
                plain.state().hash(),
                helped.with(helped.world().with(FallState.NONE).with(Arrival.NONE))
                        .hash());
    }
}
