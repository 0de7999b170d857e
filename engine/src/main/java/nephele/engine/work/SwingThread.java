package nephele.engine.work;

/**
 * The thread on which a window of Swing answers its user. What reads files, computes tables or draws pictures refuses it,
 * because a window that waits for these is frozen; the test is one comparison of names.
 */
public final class SwingThread {
    /** How the thread's name begins in every Java runtime. Headless code sees no AWT that it could ask. */
    private static final String NAME = "AWT-EventQueue-";

    private SwingThread() {}

    /**
     * Begins work that can take long.
     *
     * @param work in words, for the message
     * @throws IllegalStateException on that thread
     */
    public static void refuse(String work) {
        if (Thread.currentThread().getName().startsWith(NAME)) {
            throw new IllegalStateException(work + " may not be on the thread of the window");
        }
    }
}
