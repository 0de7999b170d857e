package nephele.editor.proving;

import java.util.concurrent.Executor;

/**
 * The executors that compute proofs and that receive their results.
 *
 * @param work runs what takes long; it may run several tasks at a time
 * @param session runs what changes the session, one after another: the event dispatch thread of a window
 */
public record ProvingThreads(Executor work, Executor session) {
    /** Everything at once, on the caller's thread: for scripts. */
    public static final ProvingThreads DIRECT = new ProvingThreads(Runnable::run, Runnable::run);

    /** Returns threads of low priority for the work. */
    public static ProvingThreads background(Executor session) {
        return new ProvingThreads(
                task -> {
                    Thread thread = new Thread(task, "proving");
                    thread.setDaemon(true);
                    thread.setPriority(Thread.MIN_PRIORITY);
                    thread.start();
                },
                session);
    }
}
