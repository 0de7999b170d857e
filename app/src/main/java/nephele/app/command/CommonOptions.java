package nephele.app.command;

import picocli.CommandLine.Option;

/** The options that every command has. */
public final class CommonOptions {
    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help.")
    boolean help;

    @Option(
            names = "--verbose",
            description = "Show the stack trace when something fails; play also writes each change of its state.")
    boolean verbose;
}
