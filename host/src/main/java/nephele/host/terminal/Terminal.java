package nephele.host.terminal;

import java.io.PrintStream;

/**
 * The output streams of a command.
 *
 * @param out receives results
 * @param err receives messages about them
 * @param shown is called once a window shows what the command does, so that {@code err} need not tell
 */
public record Terminal(PrintStream out, PrintStream err, Detail detail, Runnable shown) {
    /** How much a command tells. */
    public enum Detail {
        USUAL,
        /** With {@code --verbose}. */
        VERBOSE
    }

    /** Creates a terminal for a command without {@code --verbose}. */
    public Terminal(PrintStream out, PrintStream err) {
        this(out, err, () -> {});
    }

    /** Creates a terminal for a command without {@code --verbose} that may show a window. */
    public Terminal(PrintStream out, PrintStream err, Runnable shown) {
        this(out, err, Detail.USUAL, shown);
    }

    /** Returns this terminal with another detail. */
    public Terminal with(Detail changed) {
        return new Terminal(out, err, changed, shown);
    }
}
