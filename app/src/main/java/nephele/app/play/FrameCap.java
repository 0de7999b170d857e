package nephele.app.play;

import java.util.concurrent.locks.LockSupport;

/** Waits at the end of a frame so that no more than a number of them are shown in a second. */
final class FrameCap {
    private long nextNanos;

    /** @param framesPerSecond 0 for no cap */
    void await(double framesPerSecond) {
        long now = System.nanoTime();
        if (framesPerSecond <= 0) {
            nextNanos = now;
            return;
        }
        long period = (long) (1e9 / framesPerSecond);
        if (now - nextNanos > period) {
            nextNanos = now;
        }
        nextNanos += period;
        for (long left = nextNanos - now; left > 0; left = nextNanos - System.nanoTime()) {
            LockSupport.parkNanos(left);
        }
    }
}
