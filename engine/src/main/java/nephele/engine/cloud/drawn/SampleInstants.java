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
    static SampleInstants of(double stepSeconds, WeatherCourse course) {
        double[] times = course.keyframes().stream()
                .mapToDouble(WeatherKeyframe::timeSeconds)
                .toArray();
        return new SampleInstants(stepSeconds, course.changes() ? times : new double[0]);
    }

    /** Returns the next instant after a time's {@link #from}; that itself if time stands still. */
    double to(double seconds) {
        double from = from(seconds);
        double to = after(seconds);
        return from < to && Double.isFinite(to) ? to : from;
    }

    /** Returns the fraction of the time between the instants around a time that has passed, 0 if time stands still. */
    double passed(double seconds) {
        double from = from(seconds);
        double to = to(seconds);
        return from < to ? (seconds - from) / (to - from) : 0;
    }

    /** Returns the last instant that is not after a time. */
    double from(double seconds) {
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
