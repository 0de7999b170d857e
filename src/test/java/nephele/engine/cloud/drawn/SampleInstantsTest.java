package nephele.engine.cloud.drawn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.engine.level.Environment.WeatherKeyframe;
import nephele.engine.level.Weather;
import nephele.engine.level.appearance.WeatherCourse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** At the time of a weather keyframe its weather alone is there, for any spacing of keyframes. */
@Execution(ExecutionMode.CONCURRENT)
class SampleInstantsTest {
    private static final double SPACINGS = 18;

    /** Keyframes 1e-9 s to 1e9 s apart, as far as doubles tell them apart. */
    private static WeatherCourse course(long seed) {
        Random random = new Random(seed);
        List<WeatherKeyframe> keyframes = new ArrayList<>();
        double time = random.nextBoolean() ? 0 : random.nextDouble();
        Weather[] weathers = Weather.values();
        for (int i = 0; i < 30 && time <= 1e9; i++) {
            keyframes.add(new WeatherKeyframe(time, weathers[i % weathers.length]));
            time = Math.max(Math.nextUp(time), time + Math.pow(10, SPACINGS * random.nextDouble() - 9));
        }
        return new WeatherCourse(keyframes);
    }

    @Test
    void atAKeyframeItsWeatherIsAlone() {
        for (int seed = 0; seed < 300; seed++) {
            WeatherCourse course = course(seed);
            SampleInstants instants = SampleInstants.of(4, course);
            for (WeatherKeyframe keyframe : course.keyframes()) {
                double seconds = keyframe.timeSeconds();
                for (Weather weather : Weather.values()) {
                    assertEquals(
                            weather == keyframe.weather() ? 1 : 0, course.weight(weather, seconds), "at " + seconds);
                }
                if (course.changes()) {
                    assertEquals(seconds, instants.from(seconds));
                    assertEquals(0, instants.passed(seconds), "at " + seconds);
                }
            }
        }
    }

    @Test
    void everyTimeLiesBetweenNeighbouringInstants() {
        Random random = new Random(1);
        for (int seed = 0; seed < 300; seed++) {
            WeatherCourse course = course(seed);
            SampleInstants instants = SampleInstants.of(0.1 + 9 * random.nextDouble(), course);
            for (int i = 0; i < 100; i++) {
                double seconds = Math.pow(10, 20 * random.nextDouble() - 10);
                double from = instants.from(seconds);
                double to = instants.to(seconds);
                double passed = instants.passed(seconds);
                String span = from + " to " + to + ", " + passed;
                assertTrue(from <= seconds && seconds < to, span + " at " + seconds);
                assertTrue(passed >= 0 && passed < 1, span + " at " + seconds);
                assertEquals(to, instants.after(from), "at " + seconds);
                assertTrue(
                        course.keyframes().stream()
                                .noneMatch(
                                        key -> course.changes() && key.timeSeconds() > from && key.timeSeconds() < to),
                        span + " at " + seconds);
                double sum = 0;
                for (Weather weather : Weather.values()) {
                    sum += course.weight(weather, seconds);
                }
                assertEquals(1, sum, 1e-12);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {4, 0.3, 1 / 3.0, 1e7})
    void withoutKeyframesTheyAreTheMultiplesOfTheStep(double step) {
        SampleInstants instants = SampleInstants.of(step, new WeatherCourse(List.of()));
        for (int k = 0; k < 5000; k++) {
            assertEquals(k * step, instants.from(k * step));
            assertEquals((k + 1) * step, instants.to(k * step));
            assertEquals(0.25, instants.passed((k + 0.25) * step), 1e-9);
        }
    }

    @Test
    void whatNeverChangesAndWhatNoDoubleTellsApartStandsStill() {
        WeatherCourse one = new WeatherCourse(List.of(new WeatherKeyframe(5, Weather.FEW)));
        SampleInstants never = SampleInstants.of(Double.POSITIVE_INFINITY, one);
        assertEquals(List.of(0.0, 0.0, 0.0), List.of(never.from(1e9), never.to(1e9), never.passed(1e9)));
        for (double seconds : new double[] {Double.MIN_VALUE, 1e300, Double.MAX_VALUE}) {
            double passed = SampleInstants.of(4, one).passed(seconds);
            assertTrue(passed >= 0 && passed < 1, passed + " at " + seconds);
        }
    }
}
