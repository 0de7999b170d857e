package nephele.app.command;

import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine;

/** A command of the jar; picocli fills its annotated fields before it runs. */
public interface Command {
    /** Registers how the values of the command's own types are read. */
    default void register(CommandLine commandLine) {}

    ExitCode run(Terminal terminal) throws Exception;
}
