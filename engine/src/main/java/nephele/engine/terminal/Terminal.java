package nephele.engine.terminal;

import java.io.PrintStream;

/**
 * The output streams of a command.
 *
 * @param out receives results
 * @param err receives messages about them
 */
public record Terminal(PrintStream out, PrintStream err) {}
