package nephele.editor.document;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;

/**
 * Lets what reads files run beside the thread that needs the result. The code waits for it all the same, but the thread of
 * a window goes on painting.
 */
public final class BackgroundReading {
    private Executor waiting = Runnable::run;

    /** What is to be done. */
    @FunctionalInterface
    public interface Work<T, E extends Exception> {
        T run() throws E;
    }

    /** What is to be done without a result. */
    @FunctionalInterface
    public interface Task<E extends Exception> {
        void run() throws E;
    }

    /** @param other runs a task, and returns when it has ended; at first at once, on the caller's thread */
    public void runOn(Executor other) {
        waiting = other;
    }

    /** Does some work as {@link #get} does. */
    public <E extends Exception> void run(Task<E> work) throws E {
        get(() -> {
            work.run();
            return null;
        });
    }

    /** Returns the result of some work that touches nothing which the thread of the session changes meanwhile. */
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
