package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Environment.WeatherKeyframe;
import nephele.engine.level.Weather;
import org.junit.jupiter.api.Test;

class WeatherCourseTest {
    private static final WeatherCourse COURSE = new WeatherCourse(List.of(
            new WeatherKeyframe(10, Weather.FEW),
            new WeatherKeyframe(110, Weather.STORM),
            new WeatherKeyframe(150, Weather.STORM),
            new WeatherKeyframe(350, Weather.CLEAR)));

    @Test
    void aWeatherHasTheWholeSkyAtItsTimeAndHalfOfItBetween() {
        assertEquals(1, COURSE.weight(Weather.FEW, 0));
        assertEquals(1, COURSE.weight(Weather.FEW, 10));
        assertEquals(0.5, COURSE.weight(Weather.FEW, 60));
        assertEquals(0.5, COURSE.weight(Weather.STORM, 60));
        assertEquals(1, COURSE.weight(Weather.STORM, 130));
        assertEquals(0, COURSE.weight(Weather.STORM, 1e9));
        assertEquals(1, COURSE.weight(Weather.CLEAR, 1e9));
    }

    @Test
    void sharesSumToOneAndDoNotJump() {
        double before = COURSE.weight(Weather.STORM, 0);
        for (double seconds = 0; seconds < 400; seconds += 0.25) {
            double storm = COURSE.weight(Weather.STORM, seconds);
            double sum = storm + COURSE.weight(Weather.FEW, seconds) + COURSE.weight(Weather.CLEAR, seconds);
            assertEquals(1, sum, 1e-12, "at " + seconds);
            assertEquals(before, storm, 0.01, "at " + seconds);
            before = storm;
        }
    }

    @Test
    void changesAreCountedBetweenDifferentWeathers() {
        assertTrue(COURSE.changes());
        assertEquals(100, COURSE.shortestSeconds());
        var steady =
                new WeatherCourse(List.of(new WeatherKeyframe(0, Weather.FEW), new WeatherKeyframe(9, Weather.FEW)));
        assertFalse(steady.changes());
        assertEquals(Double.POSITIVE_INFINITY, steady.shortestSeconds());
        assertEquals(1, steady.weight(Weather.FEW, 4), 1e-12);
    }
}
