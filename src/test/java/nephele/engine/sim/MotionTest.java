package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import nephele.engine.sim.player.PlayerStep.ExponentialApproach;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The laws of motion hold at every tick rate. */
class MotionTest {
    private static final PlayerInput JUMP = PlayerInput.NONE.holding(Action.JUMP);

    /**
     * The apex of a jump is within 0.05 % of the jump height from 60 ticks a second on; below that it misses at most
     * what can fall between two ticks.
     */
    @ParameterizedTest
    @ValueSource(ints = {30, 60, 120, 240})
    void aJumpReachesItsHeight(int rate) {
        Course course = Course.onFloor().ticksPerSecond(rate);
        double[] highest = {0};
        course.hold(
                JUMP,
                0.8,
                player -> highest[0] = Math.max(highest[0], player.feet().y()));
        double missed = 9.81 / 8 / rate / rate;
        double bound = rate >= 60 ? 0.0005 : missed + 1e-9;
        assertEquals(PlayerDimensions.JUMP_METRES, highest[0], bound * PlayerDimensions.JUMP_METRES);
    }

    /** The positions of a fall are on the parabola at every tick. */
    @ParameterizedTest
    @ValueSource(ints = {30, 60, 120, 240})
    void aFallIsAParabola(int rate) {
        Course course = Course.onFloor().ticksPerSecond(rate).startAt(0, 100, 0);
        course.set(new SimState(0, 1, 0, course.state().player().withVelocity(new Vec3(3, 5, -2))));
        course.hold(PlayerInput.NONE, 4);
        Vec3 feet = course.feet();
        assertEquals(100 + 5 * 4 - 9.81 / 2 * 16, feet.y(), 1e-9);
        assertEquals(12, feet.x(), 1e-9);
        assertEquals(-8, feet.z(), 1e-9);
        assertEquals(5 - 9.81 * 4, course.state().player().velocity().y(), 1e-9);
    }

    /** The approach by 1 − exp(−k dt) does not overshoot up to k dt = 1000. */
    @Test
    void dampingNeverOvershoots() {
        for (double product = 1e-6; product <= 1000; product *= 1.7) {
            ExponentialApproach damping = ExponentialApproach.of(product * 120, 1.0 / 120);
            double after = damping.approach(-3, 5);
            assertTrue(after >= -3 && after <= 5, "k dt = " + product);
            assertTrue(damping.displacement(0, 5) >= 0 && damping.displacement(0, 5) <= 5.0 / 120);
        }
        assertEquals(5, ExponentialApproach.of(1000 * 120, 1.0 / 120).approach(-3, 5), 1e-12);
        assertEquals(0.25, ExponentialApproach.of(0, 0.5).displacement(0.5, 9), 0);
    }

    @Test
    void twoHalfTicksOfDampingAreOneWhole() {
        ExponentialApproach whole = ExponentialApproach.of(12, 1.0 / 60);
        ExponentialApproach half = ExponentialApproach.of(12, 1.0 / 120);
        double between = half.approach(1, 4);
        assertEquals(whole.approach(1, 4), half.approach(between, 4), 1e-14);
        assertEquals(whole.displacement(1, 4), half.displacement(1, 4) + half.displacement(between, 4), 1e-14);
    }

    @Test
    void startingAndStoppingIsTheSameAtAnyRate() {
        double[] z = new double[3];
        int[] rates = {60, 120, 240};
        for (int i = 0; i < 3; i++) {
            Course course = Course.onFloor().ticksPerSecond(rates[i]);
            z[i] = course.hold(PlayerInput.FORWARD, 0.5)
                    .hold(PlayerInput.NONE, 0.25)
                    .feet()
                    .z();
        }
        assertEquals(z[1], z[0], 1e-12);
        assertEquals(z[1], z[2], 1e-12);
    }

    /** Steering in the air neither brakes a flight nor accelerates it beyond running speed. */
    @Test
    void steeringInTheAirIsModest() {
        Course course = Course.onFloor().startAt(0, 400, 0);
        course.set(new SimState(0, 1, 0, course.state().player().withVelocity(new Vec3(0, 0, -30))));
        course.hold(PlayerInput.FORWARD.holding(Action.RUN), 2);
        assertEquals(-30, course.state().player().velocity().z(), 1e-9);
        course.hold(PlayerInput.NONE.walking(0, 100), 3, player -> {
            double speed = Math.hypot(player.velocity().x(), player.velocity().z());
            assertEquals(30, speed, 1e-9);
        });
        assertEquals(4, course.state().player().velocity().x(), 0.1);
    }

    @Test
    void whoFallsOutOfTheWorldBeginsAgain() {
        Course course = new Course().box(-1, -1, -1, 1, 0, 1);
        course.hold(PlayerInput.FORWARD, 6);
        assertTrue(course.feet().y() > -60);
        assertEquals(0, course.state().faults());
    }

    @Test
    void inAnEmptyLevelThePlayerHovers() {
        Course course = new Course().startAt(1, 2, 3).hold(JUMP, 5);
        assertEquals(new Vec3(1, 2, 3), course.feet());
        assertEquals(
                -4,
                course.hold(PlayerInput.FORWARD, 2).state().player().velocity().z(),
                1e-6);
    }
}
