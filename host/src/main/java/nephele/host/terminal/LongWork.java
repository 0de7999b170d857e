package nephele.host.terminal;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.function.LongSupplier;

/**
 * Says that a command is still at work: after its first second, then whenever it has been silent for a while. What it prints
 * itself, the progress of a part, counts as such a line.
 */
public final class LongWork {
    private static final long FIRST_NANOS = 1_000_000_000L;
    private static final long SILENT_NANOS = 10_000_000_000L;
    private static final long LOOK_MILLIS = 100;

    private final String work;
    private final LongSupplier nanoseconds;
    private final long start;
    private final PrintStream err;
    private long printed;
    private boolean isDone;

    /**
     * @param to receives all lines
     * @param work what is done, such as {@code nephele render level.json}
     * @param nanoseconds a clock
     */
    LongWork(OutputStream to, String work, LongSupplier nanoseconds) {
        this.work = work;
        this.nanoseconds = nanoseconds;
        start = nanoseconds.getAsLong();
        printed = start + FIRST_NANOS - SILENT_NANOS;
        err = new PrintStream(new Watched(to), true, StandardCharsets.UTF_8);
    }

    /** Returns the work of a command that begins now, watched by a thread. */
    public static LongWork begin(OutputStream to, String work) {
        var begun = new LongWork(to, work, System::nanoTime);
        var thread = new Thread(begun::watch, "long work");
        thread.setDaemon(true);
        thread.start();
        return begun;
    }

    /** Returns the stream on which the command prints. */
    public PrintStream err() {
        return err;
    }

    private void watch() {
        try {
            while (look()) {
                Thread.sleep(LOOK_MILLIS);
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }

    /** Prints a line if it is time; returns false once the work is done. */
    boolean look() {
        long now = nanoseconds.getAsLong();
        boolean isTime;
        synchronized (this) {
            isTime = !isDone && now - printed >= SILENT_NANOS;
        }
        if (isTime) {
            err.println(work + ": at work for " + PrintedProgress.duration((now - start) / 1e9) + " …");
        }
        synchronized (this) {
            return !isDone;
        }
    }

    /** Ends the watch: the work is done, or shows itself in a window. */
    public synchronized void done() {
        isDone = true;
    }

    private synchronized void printed() {
        printed = nanoseconds.getAsLong();
    }

    /** Notes when something is printed. */
    private final class Watched extends FilterOutputStream {
        private Watched(OutputStream to) {
            super(to);
        }

        @Override
        public void write(int b) throws IOException {
            printed();
            out.write(b);
        }

        @Override
        public void write(byte[] bytes, int from, int count) throws IOException {
            printed();
            out.write(bytes, from, count);
        }
    }
}
