package nephele.editor.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import nephele.editor.save.DraftLevel;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.Daylight;
import org.junit.jupiter.api.Test;

/** A level is drawn in the air that is ready, without waiting for its own. */
class AirPreparationTest {
    private final Deque<Runnable> later = new ArrayDeque<>();
    private final Set<Double> kept = new HashSet<>();
    private int repaints;
    private DoubleConsumer progress;

    private final AirPreparation air = new AirPreparation(
            environment -> kept.contains(haze(environment)), this::prepare, later::add, () -> repaints++);

    private void prepare(Environment environment, DoubleConsumer reported) {
        progress = reported;
        if (haze(environment) > 90) {
            throw new IllegalStateException("no memory");
        }
        kept.add(haze(environment));
    }

    private static double haze(Environment environment) {
        return ((Sky.Atmosphere) environment.sky()).mieScale();
    }

    private static Level level(double mieScale, double hours) {
        return DraftLevel.of("\"environment\": {\"sky\": {\"kind\": \"atmosphere\", \"mieScale\": " + mieScale
                + ", \"timeOfDayHours\": " + hours + "}}");
    }

    @Test
    void clearAirAndOtherSkiesNeedNothing() {
        Level clear = level(1, 9);
        assertSame(clear, air.of(clear));
        Level black = clear.with(clear.environment().with((Sky) null), List.of());
        assertSame(black, air.of(black));
        assertTrue(later.isEmpty());
    }

    @Test
    void otherAirIsShownWhenItIsReady() {
        Level hazy = level(3, 18);
        Level instead = air.of(hazy);
        assertEquals(level(1, 18), instead, "the hour of the one, the air of the other");
        assertSame(instead, air.of(hazy), "nothing is drawn anew while it is computed");
        assertEquals(1, later.size());
        later.poll().run();
        assertEquals(1, repaints);
        assertSame(hazy, air.of(hazy));
        assertEquals(level(3, 18), air.of(level(5, 18)), "the air that was ready last");
    }

    @Test
    void onlyTheLastOfManyWishesIsComputedNext() {
        air.of(level(3, 9));
        air.of(level(4, 9));
        Level last = level(5, 9);
        air.of(last);
        assertEquals(1, later.size());
        later.poll().run();
        assertEquals(level(3, 9), air.of(last));
        assertEquals(1, later.size());
        later.poll().run();
        assertSame(last, air.of(last));
        assertEquals(Set.of(3.0, 5.0), kept);
    }

    @Test
    void airThatCannotBePreparedIsNotTriedAgain() {
        Level thick = level(99, 9);
        air.of(thick);
        later.poll().run();
        assertSame(thick, air.of(thick));
        assertTrue(later.isEmpty());
        assertEquals(
                99, Daylight.air((Sky.Atmosphere) thick.environment().sky()).mieScale());
    }

    @Test
    void closingEndsTheComputation() {
        air.of(level(3, 9));
        later.poll().run();
        progress.accept(0.5);
        air.close();
        assertThrows(CancellationException.class, () -> progress.accept(0.6));
    }
}
