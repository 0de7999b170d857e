package nephele.engine.level.appearance;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import nephele.engine.level.Environment;
import nephele.engine.level.Environment.WeatherKeyframe;
import nephele.engine.level.Weather;

/**
 * The weather of an environment over time. Between two keyframes the extinction of one weather's clouds falls while that
 * of the other's rises, smoothly at both ends; before the first and after the last keyframe the weather stays.
 *
 * @param keyframes in the order of their times, not empty unless there is no weather
 */
public record WeatherCourse(List<WeatherKeyframe> keyframes) {
    /** Returns the course of an environment; one weather alone lasts for ever. */
    public static WeatherCourse of(Environment environment) {
        if (environment.weatherKeyframes().isEmpty() && environment.weather() != null) {
            return new WeatherCourse(List.of(new WeatherKeyframe(0, environment.weather())));
        }
        return new WeatherCourse(environment.weatherKeyframes());
    }

    /** Returns all weathers that come, each once. */
    public Set<Weather> weathers() {
        Set<Weather> all = new TreeSet<>();
        keyframes.forEach(keyframe -> all.add(keyframe.weather()));
        return all;
    }

    /** Returns true if the weather changes. */
    public boolean changes() {
        return weathers().size() > 1;
    }

    /** Returns the shortest time between two different weathers; infinite without a change. */
    public double shortestSeconds() {
        double shortest = Double.POSITIVE_INFINITY;
        for (int i = 1; i < keyframes.size(); i++) {
            if (keyframes.get(i).weather() != keyframes.get(i - 1).weather()) {
                shortest = Math.min(
                        shortest,
                        keyframes.get(i).timeSeconds() - keyframes.get(i - 1).timeSeconds());
            }
        }
        return shortest;
    }

    /** Returns the share of a weather at a time, 0 to 1; all shares together are 1. */
    public double weight(Weather weather, double seconds) {
        int next = 0;
        while (next < keyframes.size() && keyframes.get(next).timeSeconds() <= seconds) {
            next++;
        }
        if (next == 0 || next == keyframes.size()) {
            int only = Math.max(0, next - 1);
            return keyframes.get(only).weather() == weather ? 1 : 0;
        }
        WeatherKeyframe before = keyframes.get(next - 1);
        WeatherKeyframe after = keyframes.get(next);
        double s = (seconds - before.timeSeconds()) / (after.timeSeconds() - before.timeSeconds());
        double risen = s * s * (3 - 2 * s);
        return (before.weather() == weather ? 1 - risen : 0) + (after.weather() == weather ? risen : 0);
    }
}
