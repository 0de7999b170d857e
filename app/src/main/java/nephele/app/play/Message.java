package nephele.app.play;

/** A line for the player that disappears after four seconds. */
final class Message {
    private static final long SHOWN_NANOS = 4_000_000_000L;

    private String text;
    private long untilNanos;

    void say(String newText) {
        text = newText;
        untilNanos = System.nanoTime() + SHOWN_NANOS;
    }

    /** Returns the line, or null. */
    String text() {
        if (text != null && System.nanoTime() - untilNanos > 0) {
            text = null;
        }
        return text;
    }
}
