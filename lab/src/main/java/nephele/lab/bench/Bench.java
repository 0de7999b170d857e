package nephele.lab.bench;

import java.util.Arrays;
import nephele.engine.measure.FrameTimes;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;

/** Measures the time of frames. It draws rounds until the JIT is warm, and then for a given time. */
public final class Bench {
    private static final double SECONDS = 3;
    private static final int LEAST_WARM_UP_FRAMES = 20;

    private final GlContext gl;
    private final double seconds;
    private final Stopwatch stopwatch = new Stopwatch();
    private long[] wallNanos = new long[1 << 12];

    public Bench(GlContext gl) {
        this(gl, SECONDS);
    }

    /** @param seconds of warming up, and of CPU and wall time to be measured */
    Bench(GlContext gl, double seconds) {
        this.gl = gl;
        this.seconds = seconds;
    }

    /**
     * Measures whole rounds until {@code seconds} have passed on both the CPU and the wall clock, or ten times as many
     * on the wall clock.
     */
    public FrameTimes measure(Drawing drawing) {
        warmUp(drawing);
        int frames = 0;
        double draws = 0;
        double triangles = 0;
        long cpuStart = stopwatch.processCpuNanos();
        long wallStart = System.nanoTime();
        long allocatedStart = stopwatch.allocatedBytes();
        long allocatedByBench = 0;
        while (!isFull(cpuStart, wallStart)) {
            for (int frame = 0; frame < drawing.roundLength(); frame++) {
                allocatedByBench += makeRoom(frames);
                wallNanos[frames++] = timed(drawing, frame);
                draws += drawing.draws(gl);
                triangles += drawing.triangles(gl);
            }
        }
        double allocated = stopwatch.allocatedBytes() - allocatedStart - allocatedByBench;
        return new FrameTimes(
                frames,
                (stopwatch.processCpuNanos() - cpuStart) / 1e6 / frames,
                FrameTimes.percentileMs(wallNanos, frames, 0.50),
                FrameTimes.percentileMs(wallNanos, frames, 0.95),
                draws / frames,
                triangles / frames,
                allocated / frames);
    }

    private void warmUp(Drawing drawing) {
        long start = System.nanoTime();
        for (int frame = 0; frame < LEAST_WARM_UP_FRAMES || secondsSince(start) < seconds; frame++) {
            timed(drawing, frame % drawing.roundLength());
        }
    }

    private long timed(Drawing drawing, int frame) {
        long start = System.nanoTime();
        drawing.draw(frame);
        gl.finish();
        return System.nanoTime() - start;
    }

    /**
     * Returns true if enough time has passed. Both clocks count, because a waiting frame uses no CPU and a frame on two
     * cores uses CPU time twice as fast as wall time.
     */
    private boolean isFull(long cpuStart, long wallStart) {
        return secondsSince(wallStart) >= seconds && (stopwatch.processCpuNanos() - cpuStart) / 1e9 >= seconds
                || secondsSince(wallStart) >= 10 * seconds;
    }

    private long makeRoom(int frames) {
        if (frames < wallNanos.length) {
            return 0;
        }
        long before = stopwatch.allocatedBytes();
        wallNanos = Arrays.copyOf(wallNanos, 2 * frames);
        return stopwatch.allocatedBytes() - before;
    }

    private static double secondsSince(long startNanos) {
        return (System.nanoTime() - startNanos) / 1e9;
    }
}
