package nephele.workshop;

import java.util.List;
import nephele.app.Main;
import nephele.app.command.CommandEntry;
import nephele.app.command.Commands;

/** The main class of a checkout's commands: those of the jar, and the proofs. */
public final class Workshop {
    /** All commands in the order of the help text. */
    public static final List<CommandEntry> COMMANDS = Commands.ALL.stream()
            .map(entry -> entry.name().equals("prove")
                    ? new CommandEntry(entry.name(), entry.summary(), () -> new ProveCommand())
                    : entry)
            .toList();

    private Workshop() {}

    public static void main(String[] args) {
        Main.run(COMMANDS, args);
    }
}
