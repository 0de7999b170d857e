package nephele.app.play;

/** Notices that simulated time lags behind real time because frames take longer than 0.25 s. */
final class TimeLoss {
    private static final long WINDOW_NANOS = 2_000_000_000L;
    private static final double LEAST_SHARE = 0.1;

    /** The first frames of a level, which may still compile shaders. */
    private static final int SKIPPED_FRAMES = 5;

    private long windowBegin;
    private long lostAtBegin;
    private int skipped;

    /** Forgets what was before, such as the time in which a level was loaded. */
    void restart() {
        skipped = 0;
    }

    private void beginWindow(long nowNanos, long lostNanos) {
        windowBegin = nowNanos;
        lostAtBegin = lostNanos;
    }

    /** Returns true once for each two seconds of which a tenth was lost. */
    boolean isNoticed(long nowNanos, long lostNanos) {
        if (skipped < SKIPPED_FRAMES) {
            skipped++;
            beginWindow(nowNanos, lostNanos);
        }
        long elapsed = nowNanos - windowBegin;
        if (elapsed < WINDOW_NANOS) {
            return false;
        }
        boolean isLost = lostNanos - lostAtBegin > LEAST_SHARE * elapsed;
        beginWindow(nowNanos, lostNanos);
        return isLost;
    }
}
