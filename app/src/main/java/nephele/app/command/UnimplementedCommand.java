package nephele.app.command;

import java.util.List;
import nephele.engine.terminal.CommandFailure;
import nephele.engine.terminal.ExitCode;
import nephele.engine.terminal.Terminal;
import picocli.CommandLine.Unmatched;

/** A planned command that is not implemented: it answers --help and otherwise fails with a message. */
@picocli.CommandLine.Command(synopsisHeading = "Usage (not built yet): ")
final class UnimplementedCommand implements Command {
    @Unmatched
    private List<String> arguments;

    @Override
    public ExitCode run(Terminal terminal) {
        throw CommandFailure.environment(
                "this command is not built yet in this version. `nephele --help` lists the others.");
    }
}
