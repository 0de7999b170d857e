package nephele.host.terminal;

import java.io.PrintStream;

/**
 * The output streams of a command.
 *
 * @param out receives results
 * @param err receives messages about them
 * @param isVerbose whether a command reports more, with {@code --verbose}
 * @param shown is called once a window shows what the command does, so that {@code err} need not tell
 */
public record Terminal(PrintStream out, PrintStream err, boolean isVerbose, Runnable shown) {
    /** Creates a terminal for a command without {@code --verbose}. */
    public Terminal(PrintStream out, PrintStream err) {
        this(out, err, () -> {});
    }

    /** Creates a terminal for a command without {@code --verbose} that may show a window. */
    public Terminal(PrintStream out, PrintStream err, Runnable shown) {
        this(out, err, false, shown);
    }

    /** Returns this terminal with or without more detail. */
    public Terminal verbose(boolean isMore) {
        return new Terminal(out, err, isMore, shown);
    }
}
