package nephele.engine.measure;

import java.util.Arrays;
import java.util.Locale;

/**
 * The results of a benchmark. Times are in milliseconds.
 *
 * @param frames number of frames measured
 * @param cpuMsMean process CPU time a frame, over all threads of the JVM and of the OpenGL driver
 * @param wallMsP50 median of the wall time from the frame's start to the return of {@code glFinish}
 * @param wallMsP95 95th percentile of the same
 * @param draws mean number of draw calls a frame
 * @param triangles mean number of triangles a frame
 */
public record FrameTimes(
        long frames,
        double cpuMsMean,
        double wallMsP50,
        double wallMsP95,
        double draws,
        double triangles,
        double allocatedBytesPerFrame) {
    public static final String HEADER = "frames,cpuMsMean,wallMsP50,wallMsP95,draws,triangles,allocatedBytesPerFrame";

    /** Returns the results as one line in the order of {@link #HEADER}. */
    public String csv() {
        return String.format(
                Locale.ROOT,
                "%d,%.3f,%.3f,%.3f,%s,%s,%.0f",
                frames,
                cpuMsMean,
                wallMsP50,
                wallMsP95,
                counted(draws),
                counted(triangles),
                allocatedBytesPerFrame);
    }

    private static String counted(double mean) {
        return String.format(Locale.ROOT, mean == Math.rint(mean) ? "%.0f" : "%.1f", mean);
    }

    /** Returns the nearest-rank percentile of the first {@code count} values, in milliseconds. */
    public static double percentileMs(long[] nanos, int count, double fraction) {
        var sorted = Arrays.copyOf(nanos, count);
        Arrays.sort(sorted);
        int rank = (int) Math.ceil(fraction * count);
        return sorted[Math.max(0, rank - 1)] / 1e6;
    }
}
