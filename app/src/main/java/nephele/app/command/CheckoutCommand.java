package nephele.app.command;

import java.util.List;
import nephele.engine.terminal.CommandFailure;
import nephele.engine.terminal.ExitCode;
import nephele.engine.terminal.Terminal;
import picocli.CommandLine.Unmatched;

/** Stands for the proofs, which only a checkout has: names the start script that builds and runs them. */
@picocli.CommandLine.Command
final class CheckoutCommand implements Command {
    /** Whatever else is typed: the answer is the same. */
    @Unmatched
    private List<String> words;

    @Override
    public ExitCode run(Terminal terminal) {
        throw CommandFailure.environment(
                "proofs run from a checkout of the sources, which this jar is not: type" + " ./nephele prove there");
    }
}
