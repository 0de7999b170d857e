package nephele.app.play;

/** Notices that simulated time lags behind real time because frames take longer than 0.25 s. */
final class TimeLoss {
    private static final long WINDOW_NANOS = 2_000_000_000L;
    private static final double LEAST_SHARE = 0.1;

    private long windowBegin;
    private long lostAtBegin;

    /** Forgets what was before, such as the time in which a level was loaded. */
    void restart(long nowNanos, long lostNanos) {
        windowBegin = nowNanos;
        lostAtBegin = lostNanos;
    }

    /** Returns true once for each two seconds of which a tenth was lost. */
    boolean isNoticed(long nowNanos, long lostNanos) {
        long elapsed = nowNanos - windowBegin;
        if (elapsed < WINDOW_NANOS) {
            return false;
        }
        boolean isLost = lostNanos - lostAtBegin > LEAST_SHARE * elapsed;
        restart(nowNanos, lostNanos);
        return isLost;
    }
}
