package nephele.editor.document;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;

/**
 * Runs work that reads files on another thread and waits for its result. While the thread of a window waits, it goes on
 * painting.
 */
public final class BackgroundReading {
    private Executor waiting = Runnable::run;

    /** Work with a result, such as the reading of a file. */
    @FunctionalInterface
    public interface Work<T, E extends Exception> {
        T run() throws E;
    }

    /** @param other runs a task, and returns when it has ended; at first at once, on the caller's thread */
    public void runOn(Executor other) {
        waiting = other;
    }

    /** Returns the result of some work, which must touch nothing that the thread of the session changes meanwhile. */
    @SuppressWarnings("unchecked") // the work throws nothing else
    public <T, E extends Exception> T get(Work<T, E> work) throws E {
        FutureTask<T> task = new FutureTask<>(work::run);
        waiting.execute(task);
        try {
            return task.get();
        } catch (ExecutionException failure) {
            if (failure.getCause() instanceof Error error) {
                throw error;
            }
            throw (E) failure.getCause();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while waiting", interrupted);
        }
    }
}
