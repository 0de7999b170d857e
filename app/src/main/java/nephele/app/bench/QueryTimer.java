package nephele.app.bench;

import java.util.Arrays;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuTimer;

/** Asks the GPU, about one step a frame in turn: queries can't be nested. */
final class QueryTimer implements StepTimer {
    private final GpuTimer timer;
    private final double[] sumMs;
    private final long[] times;
    private int timed = -1;
    private boolean answerWaits;

    QueryTimer(GlContext gl, int steps) {
        timer = new GpuTimer(gl, "a step of a frame");
        sumMs = new double[steps];
        times = new long[steps];
    }

    @Override
    public void frameBegins() {
        if (answerWaits) {
            sumMs[timed] += timer.nanoseconds() / 1e6;
            times[timed]++;
            answerWaits = false;
        }
        timed = (timed + 1) % sumMs.length;
        if (timed == 0) {
            timer.start();
        }
    }

    @Override
    public void submitted(int step) {
        if (step == timed) {
            timer.stop();
            answerWaits = true;
        } else if (step == timed - 1) {
            timer.start();
        }
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
        return "GPU time";
    }

    @Override
    public void close() {
        timer.close();
    }
}
