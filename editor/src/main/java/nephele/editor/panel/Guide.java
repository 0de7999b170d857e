package nephele.editor.panel;

import java.util.Optional;
import nephele.editor.session.EditorSession;

/** The progress through the steps of the first room. After a step that is done comes the next one that is not. */
public final class Guide {
    private final EditorSession session;
    private int step = -1;
    /** True if the user went back to a step that is done: the guide then waits for "next". */
    private boolean waits;

    public Guide(EditorSession session) {
        this.session = session;
    }

    /** Goes to the first step that is not done, and prepares it. */
    public void start() {
        step = -1;
        next();
    }

    /** Ends the guide. */
    public void leave() {
        step = -1;
    }

    /** Returns true from start to leave, the end after the last step included. */
    public boolean isRunning() {
        return step >= 0;
    }

    /** Returns the step in progress; empty if the guide is not running or all steps are done. */
    public Optional<GuideStep> step() {
        GuideStep[] all = GuideStep.values();
        return step >= 0 && step < all.length ? Optional.of(all[step]) : Optional.empty();
    }

    /** Goes on if the step in progress is done; called after each change. Returns true if it went on. */
    public boolean follow() {
        boolean isOver = !waits
                && !session.document().isDragging()
                && step().filter(current -> current.isDone(session)).isPresent();
        if (isOver) {
            next();
        }
        return isOver;
    }

    /** Goes to the next step that is not done, past the present one. */
    public void next() {
        waits = false;
        do {
            step++;
        } while (step().filter(current -> current.isDone(session)).isPresent());
        step().ifPresent(current -> current.prepare(session));
    }

    /** Goes back by a step, done or not. */
    public void back() {
        step = Math.max(0, step - 1);
        waits = true;
        step().ifPresent(current -> current.prepare(session));
    }
}
