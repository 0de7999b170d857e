package nephele.app.command;

import java.util.function.Supplier;

/**
 * A command by name; it is built, and its classes loaded, only on demand.
 *
 * @param preload starts background loading before the options are read
 */
public record CommandEntry(String name, String summary, Supplier<Command> build, Supplier<Preload> preload) {
    /** Creates a command that loads nothing in the background. */
    public CommandEntry(String name, String summary, Supplier<Command> build) {
        this(name, summary, build, Preload::nothing);
    }
}
