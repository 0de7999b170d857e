package nephele.engine.cloud.drawn;

import java.util.Arrays;
import nephele.engine.level.Environment.WeatherKeyframe;
import nephele.engine.level.appearance.WeatherCourse;

/**
 * The times for which clouds are sampled: the multiples of a step, and those of the weather's keyframes, at each of
 * which its weather is alone, however close the next one is.
 *
 * @param stepSeconds infinite for clouds that never change: 0 is then their only instant
 * @param keyframes ascending
 */
record SampleInstants(double stepSeconds, double[] keyframes) {
    /** Two neighbouring instants, the same if time stands still, and the share of the way between them. */
    record Span(double from, double to, double share) {}

    static SampleInstants of(double stepSeconds, WeatherCourse course) {
        double[] times = course.keyframes().stream()
                .mapToDouble(WeatherKeyframe::timeSeconds)
                .toArray();
        return new SampleInstants(stepSeconds, course.changes() ? times : new double[0]);
    }

    /** Returns the span of a time: from the last instant that is not after it to the next one. */
    Span around(double seconds) {
        double from = from(seconds);
        double to = after(seconds);
        return from < to && Double.isFinite(to)
                ? new Span(from, to, (seconds - from) / (to - from))
                : new Span(from, from, 0);
    }

    private double from(double seconds) {
        if (stepSeconds == Double.POSITIVE_INFINITY) {
            return 0;
        }
        double multiple = whole(seconds) * stepSeconds;
        int last = firstAfter(seconds) - 1;
        return last >= 0 ? Math.max(multiple, keyframes[last]) : multiple;
    }

    /** Returns the first instant after a time; the time itself if there is none that a double can tell from it. */
    double after(double seconds) {
        if (stepSeconds == Double.POSITIVE_INFINITY) {
            return 0;
        }
        double next = Math.max(seconds, (whole(seconds) + 1) * stepSeconds);
        int key = firstAfter(seconds);
        return key < keyframes.length ? Math.min(next, keyframes[key]) : next;
    }

    /** Returns how many steps have passed: the last whole number whose product with the step is not after a time. */
    private double whole(double seconds) {
        double whole = Math.floor(seconds / stepSeconds);
        if (whole * stepSeconds > seconds) {
            return whole - 1;
        }
        return (whole + 1) * stepSeconds <= seconds ? whole + 1 : whole;
    }

    private int firstAfter(double seconds) {
        int found = Arrays.binarySearch(keyframes, seconds);
        return found >= 0 ? found + 1 : -found - 1;
    }
}
