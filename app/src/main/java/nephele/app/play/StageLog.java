package nephele.app.play;

import java.io.PrintStream;

/** Writes one line for each change of what the player sees, for {@code --verbose}. */
final class StageLog {
    private final PrintStream err;
    private String last = "";

    /** @param err {@code null} for no lines */
    StageLog(PrintStream err) {
        this.err = err;
    }

    /** Returns false if {@link #say} writes nothing. */
    boolean isOn() {
        return err != null;
    }

    void say(String state) {
        if (isOn() && !state.equals(last)) {
            last = state;
            err.println("state " + state);
        }
    }
}
