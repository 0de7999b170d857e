package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** Notes what a game tells, in its order: the end of a play as it is, all else as text. */
final class GameNotes implements WarmGame.Listener {
    private static final long LONGEST_SECONDS = 60;

    private final LinkedBlockingQueue<Object> told = new LinkedBlockingQueue<>();

    @Override
    public void ready() {
        told.add("ready");
    }

    @Override
    public void playing(long millis) {
        told.add("playing");
    }

    @Override
    public void baking(int percent) {
        told.add("baking " + percent);
    }

    @Override
    public void ended(PlayEnd end) {
        told.add(end);
    }

    @Override
    public void failed(String message) {
        told.add("failed: " + message);
    }

    /** Waits for the next note. */
    Object next() throws InterruptedException {
        Object next = told.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
        assertNotNull(next, "the game says nothing");
        return next;
    }

    /** Returns the notes that nobody has waited for yet. */
    List<Object> rest() {
        return List.copyOf(told);
    }
}
