package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimState;
import org.junit.jupiter.api.Test;

/** Frame times of 0, below 0, 1e-9 s and 10 s are handled; the states equal those of a replay of the same ticks. */
class FixedStepTest {
    private static final long SECOND = 1_000_000_000L;

    @Test
    void noTimeAndNegativeTimeAreNoTicks() {
        FixedStep step = new FixedStep(120);
        assertEquals(0, step.advance(0));
        assertEquals(0, step.advance(-SECOND));
        assertEquals(0, step.advance(Long.MIN_VALUE));
        assertEquals(0, step.fraction());
    }

    @Test
    void nanosecondsAddUp() {
        FixedStep step = new FixedStep(120);
        long ticks = 0;
        for (int i = 0; i < 10_000_000; i++) {
            ticks += step.advance(1);
        }
        assertEquals(1, ticks);
        assertEquals(0.2, step.fraction(), 1e-12);
    }

    @Test
    void timeHoldsDownToFourFramesASecondAndTheRestIsCounted() {
        FixedStep step = new FixedStep(120);
        for (int i = 0; i < 40; i++) {
            assertEquals(30, step.advance(SECOND / 4));
        }
        assertEquals(0, step.lostNanos());
        assertEquals(30, step.advance(10 * SECOND));
        assertEquals(9.75 * SECOND, step.lostNanos());
        assertEquals(0, step.advance(0), "nothing is caught up later");
        assertEquals(30, step.advance(Long.MAX_VALUE));
    }

    @Test
    void tenHoursOfUnevenFramesLoseNoTick() {
        FixedStep step = new FixedStep(144);
        var random = new SplittableRandom(1);
        long elapsed = 0;
        long ticks = 0;
        while (elapsed < 36_000 * SECOND) {
            long frame = random.nextLong(50_000_000);
            elapsed += frame;
            ticks += step.advance(frame);
        }
        assertEquals(elapsed * 144 / SECOND, ticks);
        assertEquals(0, step.lostNanos());
    }

    @Test
    void unevenFramesEqualAReplayOfPureTicks() {
        Course frames = Course.onFloor().box(-3, 0, -4, 3, 0.3, -2);
        Course pure = Course.onFloor().box(-3, 0, -4, 3, 0.3, -2);
        FixedStep step = new FixedStep(120);
        var random = new SplittableRandom(2);
        SimState state = frames.state();
        long[] lengths = {0, -SECOND, 1, 4_000_000, 17_000_000, 50_000_000, 10 * SECOND};
        while (state.tick() < 500) {
            int ticks = step.advance(lengths[random.nextInt(lengths.length)]);
            assertTrue(ticks <= 30);
            for (int i = 0; i < ticks; i++) {
                state = frames.simulation().step(state, PlayerInput.FORWARD);
            }
        }
        pure.hold(PlayerInput.FORWARD, state.tick() / 120.0);
        assertEquals(pure.state().hash(), state.hash());
        assertEquals(pure.state(), state);
    }
}
