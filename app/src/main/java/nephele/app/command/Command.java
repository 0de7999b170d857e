package nephele.app.command;

import nephele.app.terminal.ExitCode;
import nephele.app.terminal.Terminal;

/** One command of the jar; picocli fills its annotated fields before it runs. */
public interface Command {
    ExitCode run(Terminal terminal) throws Exception;

    /** The options that every command has. */
    CommonOptions common();
}
