package nephele.host.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The controller on seeded and recorded traces of frame costs. */
class QualityControllerTest {
    private static final double BUDGET = 33.3;
    private static final int MINUTE = 1800;

    /** The result of a trace. */
    private record Run(int frames, int over, int changes, int changesAtEnd, QualityFront.Point last) {}

    /**
     * Runs a trace.
     *
     * @param highMillis cost of each frame at quality high
     */
    private static Run run(QualityFront front, double budget, int frames, IntToDoubleFunction highMillis) {
        var controller = new QualityController(front, budget);
        double clock = 0;
        int over = 0;
        int counted = 0;
        int changes = 0;
        int atEnd = 0;
        for (int i = 0; i < frames; i++) {
            double cost = highMillis.applyAsDouble(i) * controller.point().cost();
            double seconds = Math.max(cost, budget) / 1000;
            clock += seconds;
            if (clock > 2) {
                counted++;
                over += cost > budget ? 1 : 0;
            }
            if (controller.add(cost, seconds) && clock > 2) {
                changes++;
                atEnd += i > frames - MINUTE ? 1 : 0;
            }
        }
        return new Run(counted, over, changes, atEnd, controller.point());
    }

    /** Noise of a few percent, and a frame in five hundred that takes half as long again. */
    private static IntToDoubleFunction noisy(long seed, IntToDoubleFunction clean) {
        var random = new SplittableRandom(seed);
        return frame -> clean.applyAsDouble(frame)
                * Math.exp(0.05 * random.nextGaussian())
                * (random.nextInt(500) == 0 ? 1.5 : 1);
    }

    static Stream<Arguments> steady() {
        return Stream.of(12.0, 20.0, 40.0, 55.0, 70.0, 100.0, 110.0)
                .flatMap(cost -> Stream.of(1L, 2L, 3L).map(seed -> Arguments.of(cost, seed)));
    }

    @ParameterizedTest
    @MethodSource("steady")
    void steadyScenesStayAtOnePoint(double highMillis, long seed) {
        Run run = run(QualityFront.SOFTWARE, BUDGET, 4 * MINUTE, noisy(seed, frame -> highMillis));
        assertTrue(run.over < 0.01 * run.frames, run.toString());
        assertTrue(run.changes <= 6, run.toString());
        assertTrue(run.changesAtEnd <= 1, run.toString());
    }

    /** A walk whose cost swells and falls slowly, and doubles in one step every minute. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void walksStayWithinTheBudget(long seed) {
        IntToDoubleFunction walk = frame ->
                (45 + 12 * Math.sin(frame / 400.0) + 5 * Math.sin(frame / 90.0)) * (frame / MINUTE % 2 == 0 ? 1 : 1.5);
        Run run = run(QualityFront.SOFTWARE, BUDGET, 6 * MINUTE, noisy(seed, walk));
        assertTrue(run.over < 0.01 * run.frames, run.toString());
        assertTrue(run.changes <= 6 * MINUTE / 300, run.toString());
    }

    /**
     * Costs recorded while a level's solution was shown in a window of 640x360, divided by that of the point that drew
     * each frame: with the hitches of a busy machine.
     */
    @ParameterizedTest
    @ValueSource(strings = {"01-courtyard", "04-cube"})
    void recordedWalksStayWithinTheBudget(String level) throws IOException {
        double[] costs = recorded(level);
        Run run = run(QualityFront.SOFTWARE, BUDGET, costs.length, frame -> costs[frame]);
        assertTrue(run.over < 0.01 * run.frames, run.toString());
        assertTrue(run.changes <= costs.length / 300 + 1, run.toString());
    }

    private static double[] recorded(String level) throws IOException {
        try (var lines = new BufferedReader(new InputStreamReader(
                QualityControllerTest.class.getResourceAsStream("cost-" + level + ".txt"),
                StandardCharsets.US_ASCII))) {
            return lines.lines().mapToDouble(Double::parseDouble).toArray();
        }
    }

    /** Returns the changes in the first ten seconds of frames. */
    private static int earlyChanges(QualityController controller, double[] highMillis) {
        int changes = 0;
        double clock = 0;
        for (int i = 0; i < highMillis.length && clock < 10; i++) {
            double cost = highMillis[i] * controller.point().cost();
            double seconds = Math.max(cost, BUDGET) / 1000;
            clock += seconds;
            changes += controller.add(cost, seconds) ? 1 : 0;
        }
        return changes;
    }

    static Stream<Arguments> machines() {
        return Stream.of("01-courtyard", "04-cube")
                .flatMap(level -> DoubleStream.of(0.1, 0.2, 0.35, 0.5, 0.7, 1, 1.4, 2, 4)
                        .mapToObj(slowness -> Arguments.of(level, slowness)));
    }

    /**
     * Recorded walks on machines of other speeds: with what was learned in a walk, at most one change in the first ten
     * seconds of the next one, whose frames are those of the first with other noise.
     */
    @ParameterizedTest
    @MethodSource("machines")
    void aMachineSeenBeforeIsSteadyAtOnce(String level, double slowness) throws IOException {
        double[] walk =
                Arrays.stream(recorded(level)).map(cost -> slowness * cost).toArray();
        var first = new QualityController(QualityFront.SOFTWARE, BUDGET);
        for (double cost : walk) {
            first.add(cost * first.point().cost(), BUDGET / 1000);
        }
        for (long seed = 1; seed <= 5; seed++) {
            var controller = new QualityController(QualityFront.SOFTWARE, BUDGET);
            controller.begin(first.learnedHighMillis());
            var noise = noisy(seed, frame -> walk[frame]);
            double[] again = IntStream.range(0, walk.length)
                    .mapToDouble(noise::applyAsDouble)
                    .toArray();
            int changes = earlyChanges(controller, again);
            assertTrue(changes <= 1, changes + " changes, seed " + seed + ", now " + controller.point());
        }
    }

    /** The same where nothing is known but the cheapest of four frames of the first view. */
    @ParameterizedTest
    @MethodSource("machines")
    void aNewMachineIsSteadySoon(String level, double slowness) throws IOException {
        double[] walk =
                Arrays.stream(recorded(level)).map(cost -> slowness * cost).toArray();
        var controller = new QualityController(QualityFront.SOFTWARE, BUDGET);
        controller.begin(1.4 * Arrays.stream(walk, 2, 6).min().orElseThrow());
        int changes = earlyChanges(controller, walk);
        assertTrue(changes <= 3, changes + " changes, now " + controller.point());
    }

    /** The cost between two points, where each climb fails: the time between climbs grows. */
    @Test
    void failedClimbsBecomeRare() {
        var dear = new QualityFront(
                Stream.of(new QualityFront.Point("cheap", null, 1), new QualityFront.Point("dear", null, 1.01))
                        .toList(),
                0);
        var controller = new QualityController(dear, BUDGET);
        int changes = 0;
        for (int frame = 0; frame < 20 * MINUTE; frame++) {
            double cost = controller.point().name().equals("dear") ? 50 : 20;
            changes += controller.add(cost, BUDGET / 1000) ? 1 : 0;
        }
        assertTrue(changes <= 16, changes + " changes in twenty minutes");
    }

    /** Three slow frames every ten seconds, as by screenshots or other programs, change nothing. */
    @Test
    void aHitchChangesNothing() {
        IntToDoubleFunction hitches = frame -> frame % 300 < 3 ? 400 : 60;
        Run run = run(QualityFront.SOFTWARE, BUDGET, 2 * MINUTE, hitches);
        assertEquals(0, run.changesAtEnd, run.toString());
    }

    @Test
    void firstFramesDecideAtOnce() {
        assertEquals(
                "ultra", run(QualityFront.SOFTWARE, BUDGET, 30, frame -> 5).last.name());
        assertEquals(
                "resolution 0.25",
                run(QualityFront.SOFTWARE, BUDGET, 30, frame -> 900).last.name());
        assertEquals(
                "ultra",
                run(QualityFront.HARDWARE, 1000 / 60.0, 30, frame -> 2).last.name());
        assertEquals(
                "low",
                run(QualityFront.HARDWARE, 1000 / 60.0, 30, frame -> 40).last.name());
    }

    /** Programs are compiled in the first frames after a change: their time decides nothing. */
    @Test
    void framesAfterAChangeAreNotCounted() {
        var controller = new QualityController(QualityFront.SOFTWARE, BUDGET);
        int changes = 0;
        for (int frame = 0; frame < 200; frame++) {
            boolean isWarmUp = frame < QualityController.FIRST_WARM_UP_FRAMES;
            changes += controller.add(isWarmUp ? 2000 : 100 * controller.point().cost(), BUDGET / 1000) ? 1 : 0;
        }
        assertEquals("low", controller.point().name());
        assertEquals(0, changes);
    }
}
