package nephele.engine.render.timing;

import java.util.Arrays;

/** Mean times of the steps of frames, in milliseconds. */
final class StepMeans {
    private final double[] sumMs;
    private final long[] times;

    StepMeans(int steps) {
        sumMs = new double[steps];
        times = new long[steps];
    }

    int steps() {
        return times.length;
    }

    void add(int step, long nanoseconds) {
        sumMs[step] += nanoseconds / 1e6;
        times[step]++;
    }

    /** Returns 0 before the step was timed. */
    double meanMs(int step) {
        return sumMs[step] / Math.max(1, times[step]);
    }

    void reset() {
        Arrays.fill(sumMs, 0);
        Arrays.fill(times, 0);
    }
}
