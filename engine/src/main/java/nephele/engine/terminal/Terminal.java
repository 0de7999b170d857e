package nephele.engine.terminal;

import java.io.PrintStream;

/**
 * The output streams of a command.
 *
 * @param out receives results
 * @param err receives messages about them
 */
public record Terminal(PrintStream out, PrintStream err, Detail detail) {
    /** How much a command tells. */
    public enum Detail {
        USUAL,
        /** With {@code --verbose}. */
        VERBOSE
    }

    /** Creates a terminal for a command without {@code --verbose}. */
    public Terminal(PrintStream out, PrintStream err) {
        this(out, err, Detail.USUAL);
    }

    /** Returns this terminal with another detail. */
    public Terminal with(Detail changed) {
        return new Terminal(out, err, changed);
    }
}
