package nephele.workshop.prove.editor;

import java.awt.EventQueue;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;

/** Asks Swing's thread for an answer again and again, and keeps how long the slowest one was awaited. */
final class AnswerWatch {
    private static final long BETWEEN_NANOS = 5_000_000;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final Thread asking = new Thread(this::ask, "answers");
    private volatile boolean isOver;
    private long dispatcher;
    private long longestNanos;
    private long dearestNanos;

    void begin() {
        asking.setDaemon(true);
        asking.start();
    }

    private void ask() {
        try {
            long before = answered();
            while (!isOver) {
                long start = System.nanoTime();
                long after = answered();
                longestNanos = Math.max(longestNanos, System.nanoTime() - start);
                dearestNanos = Math.max(dearestNanos, after - before);
                before = after;
                LockSupport.parkNanos(BETWEEN_NANOS);
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Waits for an answer; returns the time that the thread has worked since it began. */
    private long answered() throws InterruptedException {
        var answer = new CountDownLatch(1);
        EventQueue.invokeLater(() -> {
            dispatcher = Thread.currentThread().getId();
            answer.countDown();
        });
        answer.await();
        return threads.getThreadCpuTime(dispatcher);
    }

    void end() throws InterruptedException {
        isOver = true;
        asking.join();
    }

    /** Returns the longest time for which an answer was awaited, after the {@link #end}. */
    double longestSeconds() {
        return longestNanos * 1e-9;
    }

    /** Returns the most time that the thread itself has worked between two answers. */
    double dearestSeconds() {
        return dearestNanos * 1e-9;
    }
}
