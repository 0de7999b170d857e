package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** Notes what a game reports, in its order: the end of a play as it is, all else as text. */
final class GameNotes implements Consumer<PlayAnswer> {
    private static final long LONGEST_SECONDS = 60;

    private final LinkedBlockingQueue<Object> notes = new LinkedBlockingQueue<>();

    @Override
    public void accept(PlayAnswer answer) {
        if (answer instanceof PlayAnswer.Ended ended) {
            notes.add(ended.end());
        } else if (answer instanceof PlayAnswer.Failed failed) {
            notes.add("failed: " + failed.message());
        } else {
            notes.add(answer instanceof PlayAnswer.Playing ? "playing" : answer.line());
        }
    }

    /** Waits for the next note. */
    Object next() throws InterruptedException {
        Object next = notes.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
        assertNotNull(next, "the game says nothing");
        return next;
    }

    /** Returns the notes that nobody has waited for yet. */
    List<Object> rest() {
        return List.copyOf(notes);
    }
}
