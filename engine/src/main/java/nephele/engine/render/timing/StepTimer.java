package nephele.engine.render.timing;

import java.util.Arrays;
import java.util.function.LongSupplier;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuTimer;

/**
 * Times the steps of frames: on hardware one step of each frame in turn by queries, which cannot be nested; in software,
 * whose timer queries are wrong, all steps by waiting for each to complete.
 */
public final class StepTimer implements StepListener, AutoCloseable {
    private final GlContext gl;
    /** {@code null} in software. */
    private final GpuTimer queries;

    private final Clock software;

    private final double[] sumMs;
    private final long[] times;
    private int queried = -1;
    private boolean answerWaits;
    private long lastNanos;

    /**
     * A clock of steps in software, where each is waited for.
     *
     * @param title for readers of the figures
     * @param nanoseconds since any moment
     */
    public record Clock(String title, LongSupplier nanoseconds) {
        public static final Clock WALL = new Clock("wall time to glFinish", System::nanoTime);
    }

    private StepTimer(GlContext gl, GpuTimer queries, Clock software, int steps) {
        this.gl = gl;
        this.queries = queries;
        this.software = software;
        sumMs = new double[steps];
        times = new long[steps];
    }

    public static StepTimer of(GlContext gl, Clock software, int steps) {
        GpuTimer queries = gl.limits().software() ? null : new GpuTimer(gl, "a step of a frame");
        return new StepTimer(gl, queries, software, steps);
    }

    /** Returns the number of frames in which each step is timed once. */
    public int framesOfARound() {
        return queries == null ? 1 : times.length;
    }

    /** Must be called before each timed frame. */
    public void frameBegins() {
        if (queries == null) {
            gl.finish();
            lastNanos = software.nanoseconds.getAsLong();
            return;
        }
        if (answerWaits) {
            add(queried, queries.nanoseconds());
            answerWaits = false;
        }
        queried = (queried + 1) % times.length;
        if (queried == 0) {
            queries.start();
        }
    }

    @Override
    public void submitted(int step) {
        if (queries == null) {
            gl.finish();
            long now = software.nanoseconds.getAsLong();
            add(step, now - lastNanos);
            lastNanos = now;
        } else if (step == queried) {
            queries.stop();
            answerWaits = true;
        } else if (step == queried - 1) {
            queries.start();
        }
    }

    private void add(int step, long nanoseconds) {
        sumMs[step] += nanoseconds / 1e6;
        times[step]++;
    }

    /** Returns the mean time of one step since the last {@link #reset}; 0 before it was timed. */
    public double meanMs(int step) {
        return sumMs[step] / Math.max(1, times[step]);
    }

    /** Discards the measured times. */
    public void reset() {
        Arrays.fill(sumMs, 0);
        Arrays.fill(times, 0);
    }

    /** Returns the name of the clock, for readers of the figures. */
    public String clock() {
        return queries == null ? software.title : "GPU time";
    }

    @Override
    public void close() {
        if (queries != null) {
            queries.close();
        }
    }
}
