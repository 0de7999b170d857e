package nephele.engine.terminal;

import java.io.PrintStream;

/** Where a command writes: results to {@code out}, everything about them to {@code err}. */
public record Terminal(PrintStream out, PrintStream err) {}
