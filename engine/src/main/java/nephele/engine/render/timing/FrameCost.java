package nephele.engine.render.timing;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuTimer;

/**
 * The time that a frame takes, without waiting for the display: on hardware the longer of the CPU's time until all is
 * submitted and the GPU's time for the last frame that it has finished; in software, which draws before it shows, the
 * time until it is shown.
 */
public final class FrameCost implements AutoCloseable {
    /** {@code null} in software. */
    private final GpuTimer timer;

    private boolean isTimed;
    private boolean answerWaits;
    private double gpuMillis;
    private double submitMillis;
    private double millis;
    private long startNanos;

    public FrameCost(GlContext gl) {
        timer = gl.limits().software() ? null : new GpuTimer(gl, "a frame");
    }

    /**
     * Begins a frame.
     *
     * @param otherQueries true if other timer queries run in this frame, since queries cannot be nested
     */
    public void begins(boolean otherQueries) {
        if (answerWaits && timer.isDone()) {
            gpuMillis = timer.nanoseconds() / 1e6;
            answerWaits = false;
        }
        isTimed = timer != null && !otherQueries && !answerWaits;
        if (isTimed) {
            timer.start();
        }
        startNanos = System.nanoTime();
    }

    /** Called when all draws are submitted, before the frame is shown. */
    public void submitted() {
        if (isTimed) {
            timer.stop();
            answerWaits = true;
        }
        submitMillis = (System.nanoTime() - startNanos) / 1e6;
    }

    /** Called when the frame is shown. */
    public void presented() {
        millis = timer == null ? (System.nanoTime() - startNanos) / 1e6 : Math.max(submitMillis, gpuMillis);
    }

    /** Returns the cost of the last frame. */
    public double millis() {
        return millis;
    }

    @Override
    public void close() {
        if (timer != null) {
            timer.close();
        }
    }
}
