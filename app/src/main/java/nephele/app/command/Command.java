package nephele.app.command;

import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;

/** A command of the jar; picocli fills its annotated fields before it runs. */
public interface Command {
    ExitCode run(Terminal terminal) throws Exception;
}
