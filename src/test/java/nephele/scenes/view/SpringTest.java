package nephele.scenes.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.SeededNoise;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Any subdivision of the time gives the same result, and it is that of a towed rope. */
class SpringTest {
    private static final double SPEED = 6;
    private static final SeededNoise NOISE = new SeededNoise(53);

    /** A spring and the accumulated motion of its camera. */
    private record Track(Spring spring, double cameraRight, double cameraAhead) {
        static Track atRest() {
            return new Track(Spring.atRest(1), 0, 0);
        }

        Track after(double seconds, Steering steering) {
            Spring.Step step = spring.after(seconds, steering);
            return new Track(step.spring(), cameraRight + step.cameraRight(), cameraAhead + step.cameraAhead());
        }

        double force() {
            return Math.hypot(spring.currentRight(), spring.currentAhead());
        }

        double entityRight() {
            return cameraRight + spring.currentRight();
        }

        double entityAhead() {
            return cameraAhead + spring.currentAhead();
        }
    }

    private static Steering towards(double degrees) {
        return new Steering(Math.cos(Math.toRadians(degrees)), Math.sin(Math.toRadians(degrees)), SPEED);
    }

    private static void assertSameTrack(Track expected, Track actual, double tolerance) {
        assertEquals(expected.cameraRight, actual.cameraRight, tolerance, "camera to the right");
        assertEquals(expected.cameraAhead, actual.cameraAhead, tolerance, "camera ahead");
        assertEquals(expected.spring.currentRight(), actual.spring.currentRight(), tolerance, "force to the right");
        assertEquals(expected.spring.currentAhead(), actual.spring.currentAhead(), tolerance, "force ahead");
    }

    @Test
    void theEntityGoesAloneUntilTheForceIsOneAndThenTakesTheCameraAlong() {
        var ahead = towards(90);
        var alone = Track.atRest().after(0.999 / SPEED, ahead);
        assertEquals(0.999, alone.force(), 1e-12);
        assertEquals(0, alone.cameraAhead, 1e-12);
        var along = Track.atRest().after(5 / SPEED, ahead);
        assertEquals(1, along.force(), 1e-12);
        assertEquals(4, along.cameraAhead, 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 30, 45, 90, 135, 180, 200, 270, 315})
    void everyDirectionIsTheSame(double degrees) {
        var there = Track.atRest().after(2, towards(degrees));
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        assertEquals(11 * cos, there.cameraRight, 1e-12);
        assertEquals(11 * sin, there.cameraAhead, 1e-12);
        assertEquals(cos, there.spring.currentRight(), 1e-12);
        assertEquals(sin, there.spring.currentAhead(), 1e-12);
    }

    @Test
    void theReturnBeginsThreeTenthsOfASecondAfterTheLastKeyAndTheEntityStaysWhereItIs() {
        var towed = Track.atRest().after(1, towards(30));
        var paused = towed.after(0.3, Steering.NONE);
        assertSameTrack(towed, paused, 1e-15);
        var returning = paused.after(Spring.RETURN_SECONDS / 2, Steering.NONE);
        assertEquals(0.5, returning.force(), 1e-12, "half of it half-way: the fading is symmetric");
        assertEquals(towed.entityRight(), returning.entityRight(), 1e-12);
        assertEquals(towed.entityAhead(), returning.entityAhead(), 1e-12);
        var back = returning.after(Spring.RETURN_SECONDS / 2 + 1e-9, Steering.NONE);
        assertEquals(0, back.force());
        assertEquals(towed.entityRight(), back.cameraRight, 1e-12);
        assertSameTrack(back, back.after(10, Steering.NONE), 1e-15);
    }

    @Test
    void aKeyDuringTheReturnGoesOnFromWhereTheEntityIs() {
        var returning = Track.atRest().after(1, towards(90)).after(0.3 + Spring.RETURN_SECONDS / 2, Steering.NONE);
        var moved = returning.after(0.01, towards(270));
        assertEquals(0.5 - 0.01 * SPEED, moved.spring.currentAhead(), 1e-12);
        assertEquals(returning.cameraAhead, moved.cameraAhead, 1e-12, "it goes alone again");
    }

    /**
     * The closed form agrees with small steps of an inextensible rope: the displacement grows by the step and is cut
     * back to the rope's length.
     */
    @ParameterizedTest
    @ValueSource(doubles = {10, 60, 89, 120, 179})
    void towingIsARopeThatIsPulled(double degrees) {
        var towed = Track.atRest().after(1, towards(0));
        double seconds = 0.4;
        int steps = 200_000;
        double right = 1;
        double ahead = 0;
        var steering = towards(degrees);
        for (int i = 0; i < steps; i++) {
            right += steering.right() * SPEED * seconds / steps;
            ahead += steering.ahead() * SPEED * seconds / steps;
            double length = Math.max(1, Math.hypot(right, ahead));
            right /= length;
            ahead /= length;
        }
        var exact = towed.after(seconds, steering);
        assertEquals(right, exact.spring.currentRight(), 1e-5);
        assertEquals(ahead, exact.spring.currentAhead(), 1e-5);
        assertEquals(towed.entityRight() + steering.right() * SPEED * seconds, exact.entityRight(), 1e-12);
        assertEquals(towed.entityAhead() + steering.ahead() * SPEED * seconds, exact.entityAhead(), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1.0 / 240, 1.0 / 30, 0.1, 0.29, 0.31, 0.9, 1, 10})
    void oneStepIsTwoHalvesInEveryPhase(double seconds) {
        for (int round = 0; round < 500; round++) {
            var from = anyState(round);
            var steering = anySteering(round, 7);
            var once = from.after(seconds, steering);
            var twice = from.after(seconds / 2, steering).after(seconds / 2, steering);
            assertSameTrack(once, twice, 1e-12);
        }
    }

    /** Steps of one second agree with those of every frame rate, across the ends of all phases. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 30, 60, 144, 240, 1000})
    void everyFrameRateLeadsToTheSamePlace(int framesPerSecond) {
        var once = Track.atRest();
        var often = Track.atRest();
        for (int second = 0; second < 12; second++) {
            var steering = anySteering(second, 3);
            once = once.after(1, steering);
            for (int frame = 0; frame < framesPerSecond; frame++) {
                often = often.after(1.0 / framesPerSecond, steering);
            }
        }
        assertSameTrack(once, often, 1e-11);
    }

    @Test
    void randomSplitsLeadToTheSamePlace() {
        for (int round = 0; round < 200; round++) {
            var from = anyState(round);
            var steering = anySteering(round, 11);
            double seconds = 2 * NOISE.unit(round, 0, 12);
            var split = from;
            double spent = 0;
            for (int i = 0; i < 9; i++) {
                double part = (seconds - spent) * NOISE.unit(round, i, 13);
                split = split.after(part, steering);
                spent += part;
            }
            assertSameTrack(from.after(seconds, steering), split.after(seconds - spent, steering), 1e-12);
        }
    }

    @Test
    void theForceIsNeverLongerThanItsMost() {
        var track = Track.atRest();
        for (int i = 0; i < 20_000; i++) {
            track = track.after(0.2 * NOISE.unit(i, 1, 1), anySteering(i, 5));
            assertTrue(track.force() <= 1 + 1e-12, "step " + i + ": " + track.force());
        }
        assertTrue(Math.abs(track.cameraRight) > 1, "it went somewhere");
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, -1, -0.0, 0, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY})
    void aTimeThatIsNoneChangesNothing(double seconds) {
        var spring = Track.atRest().after(0.1, towards(20)).spring();
        assertSame(spring, spring.after(seconds, towards(70)).spring());
        assertEquals(0, spring.after(seconds, towards(70)).cameraAhead());
    }

    @Test
    void keysThatPointNowhereSteerNowhere() {
        assertEquals(Steering.NONE, new Steering(0, 0, 6));
        assertEquals(Steering.NONE, new Steering(Double.NaN, 1, 6));
        assertEquals(Steering.NONE, new Steering(1, 0, Double.NaN));
        assertEquals(Steering.NONE, new Steering(1, 0, -6));
        assertEquals(Steering.NONE, new Steering(1, 0, Double.POSITIVE_INFINITY));
        assertEquals(Math.sqrt(0.5), new Steering(1, -1, 6).right(), 1e-15, "a diagonal is no faster");
    }

    @Test
    void withoutAnEntityTheCameraMovesAtOnce() {
        Spring.Step step = Spring.atRest(0).after(0.5, towards(90));
        assertEquals(3, step.cameraAhead(), 1e-12);
        assertEquals(0, step.cameraRight(), 1e-12);
        assertEquals(0, step.spring().currentAhead());
    }

    /** Returns a state at rest, moving alone, towed, paused or returning. */
    private static Track anyState(int round) {
        var track = Track.atRest();
        for (int i = 0; i < round % 4; i++) {
            track = track.after(NOISE.unit(round, i, 2), anySteering(round + i, 4));
        }
        return track;
    }

    private static Steering anySteering(int round, int salt) {
        return NOISE.unit(round, salt, 6) < 0.35
                ? Steering.NONE
                : towards(45 * Math.floor(8 * NOISE.unit(round, salt, 8)));
    }
}
