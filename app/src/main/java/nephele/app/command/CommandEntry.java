package nephele.app.command;

import java.util.function.Supplier;

/** A command by name; it is built, and its classes loaded, only when it is asked for. */
public record CommandEntry(String name, String summary, Supplier<Command> build) {}
