package nephele.app.bench;

import java.util.Arrays;
import nephele.engine.render.gl.GlContext;

/** Waits for each step to be drawn before the next one begins. */
final class FinishTimer implements StepTimer {
    private final GlContext gl;
    private final double[] sumMs;
    private final long[] times;
    private long lastNanos;

    FinishTimer(GlContext gl, int steps) {
        this.gl = gl;
        sumMs = new double[steps];
        times = new long[steps];
    }

    @Override
    public void frameBegins() {
        gl.finish();
        lastNanos = System.nanoTime();
    }

    @Override
    public void submitted(int step) {
        gl.finish();
        long now = System.nanoTime();
        sumMs[step] += (now - lastNanos) / 1e6;
        times[step]++;
        lastNanos = now;
    }

    @Override
    public double meanMs(int step) {
        return sumMs[step] / Math.max(1, times[step]);
    }

    @Override
    public void reset() {
        Arrays.fill(sumMs, 0);
        Arrays.fill(times, 0);
    }

    @Override
    public String clock() {
        return "wall time to glFinish";
    }

    @Override
    public void close() {
        reset();
    }
}
