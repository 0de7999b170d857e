package nephele.app.command;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.ProgramVersion;
import nephele.host.terminal.Terminal;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Maps arguments to an exit code: finds the command, lets picocli read its options, runs it and reports failures. */
public final class CommandLineFront {
    private static final int FARTHEST_TYPING_ERROR = 2;

    private static final int NAME_WIDTH = 10;

    private final Terminal terminal;
    private final List<CommandEntry> commands;

    /** @param commands in the order of the help text */
    public CommandLineFront(Terminal terminal, List<CommandEntry> commands) {
        this.terminal = terminal;
        this.commands = commands;
    }

    /** Runs the command of the arguments. Returns exit code 3 if its output could not be written. */
    public ExitCode run(String... arguments) {
        var exitCode = answer(arguments);
        if (!terminal.out().checkError()) {
            return exitCode;
        }
        terminal.err()
                .println("nephele: the output is incomplete, it could not be written: make room on the device, or read"
                        + " it to its end");
        return exitCode == ExitCode.DONE ? ExitCode.ENVIRONMENT : exitCode;
    }

    private ExitCode answer(String... arguments) {
        var words = List.of(arguments);
        if (words.isEmpty() || words.get(0).equals("--help") || words.get(0).equals("-h")) {
            (words.isEmpty() ? terminal.err() : terminal.out()).print(overview());
            return words.isEmpty() ? ExitCode.USAGE : ExitCode.DONE;
        }
        if (words.get(0).equals("--version")) {
            terminal.out().println(ProgramVersion.line());
            return ExitCode.DONE;
        }
        var entry = commands.stream()
                .filter(known -> known.name().equals(words.get(0)))
                .findFirst();
        if (entry.isEmpty()) {
            terminal.err().println("nephele: " + unknown(words.get(0)));
            return ExitCode.USAGE;
        }
        return run(entry.get(), arguments);
    }

    private ExitCode run(CommandEntry entry, String[] arguments) {
        var preload = entry.preload().get();
        try {
            return run(entry, entry.build().get(), arguments);
        } finally {
            preload.finish();
        }
    }

    private ExitCode run(CommandEntry entry, Command command, String[] arguments) {
        var commandLine = new CommandLine(command);
        var common = new CommonOptions();
        commandLine.addMixin("common", common).setExpandAtFiles(false);
        OptionValues.register(commandLine);
        command.register(commandLine);
        commandLine
                .getCommandSpec()
                .name("nephele " + entry.name())
                .usageMessage()
                .description(entry.summary());
        try {
            var parsed = commandLine.parseArgs(Arrays.copyOfRange(arguments, 1, arguments.length));
            if (parsed.isUsageHelpRequested()) {
                commandLine.usage(terminal.out(), Ansi.OFF);
                return ExitCode.DONE;
            }
            OptionRange.check(commandLine, parsed);
            return command.run(terminal.verbose(common.verbose));
        } catch (ParameterException wrongUsage) {
            terminal.err()
                    .println("nephele " + entry.name() + ": " + OptionRange.message(wrongUsage) + proposal(wrongUsage));
            terminal.err().println("`nephele " + entry.name() + " --help` lists what it takes.");
            return ExitCode.USAGE;
        } catch (Exception | LinkageError | OutOfMemoryError | StackOverflowError failure) {
            var explained = Explanation.of(failure, List.of(arguments));
            return explained.report(terminal, "nephele " + entry.name(), common.verbose);
        }
    }

    /** Returns a question about an unknown option that resembles a known one. */
    private static String proposal(ParameterException wrongUsage) {
        if (!(wrongUsage instanceof UnmatchedArgumentException unmatched)) {
            return "";
        }
        var known = unmatched.getCommandLine().getCommandSpec().optionsMap().keySet();
        return unmatched.getUnmatched().stream()
                .filter(word -> word.startsWith("-"))
                .map(word -> didYouMean(word.replaceFirst("=.*", ""), known.stream()))
                .filter(text -> !text.isEmpty())
                .findFirst()
                .orElse("");
    }

    private String overview() {
        var lines = commands.stream()
                .map(entry -> "  " + padded(entry.name()) + entry.summary() + "\n")
                .collect(Collectors.joining());
        return "Usage: nephele COMMAND [ARGUMENT...]\n\n" + lines
                + "\n"
                + "`nephele COMMAND --help` tells more, `nephele --version` the version. Exit codes: 0 done, 1 the"
                + " input has errors, 2 wrong usage, 3 the environment lacks something.\n";
    }

    private String unknown(String word) {
        return "unknown command `" + word + "`"
                + didYouMean(word, commands.stream().map(CommandEntry::name))
                + "\n`nephele --help` lists the commands.";
    }

    private static String padded(String name) {
        return name + " ".repeat(Math.max(1, NAME_WIDTH - name.length()));
    }

    /** The options that every command has. */
    static final class CommonOptions {
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

    /** Returns the nearest known word within two typing errors. */
    private static Optional<String> nearest(String typed, Stream<String> known) {
        return known.min(Comparator.comparingInt(word -> editDistance(word, typed)))
                .filter(word -> editDistance(word, typed) <= FARTHEST_TYPING_ERROR);
    }

    /** Returns a question that ends a message about an unknown word; empty if no known word is near. */
    private static String didYouMean(String typed, Stream<String> known) {
        return nearest(typed, known)
                .map(word -> "; did you mean `" + word + "`?")
                .orElse("");
    }

    /** Returns the edit distance of Levenshtein (1966): the least number of letters to insert, remove or replace. */
    private static int editDistance(String a, String b) {
        int[] previous = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            previous[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] current = new int[b.length() + 1];
            current[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int change = previous[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                current[j] = Math.min(change, 1 + Math.min(previous[j], current[j - 1]));
            }
            previous = current;
        }
        return previous[b.length()];
    }
}
