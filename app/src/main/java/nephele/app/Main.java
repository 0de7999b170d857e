package nephele.app;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import nephele.app.command.CommandEntry;
import nephele.app.command.CommandLineFront;
import nephele.app.command.Commands;
import nephele.host.terminal.LongWork;
import nephele.host.terminal.Terminal;

/** The main class of the jar. */
public final class Main {
    private Main() {}

    public static void main(String[] args) {
        run(Commands.ALL, args);
    }

    /** Runs one of these commands and ends the process with its exit code. */
    public static void run(List<CommandEntry> commands, String... args) {
        Utf8Locale.require();
        MesaCache.protect();
        Locale.setDefault(Locale.ROOT);
        trustExtractedLibraries();
        var work = LongWork.begin(new FileOutputStream(FileDescriptor.err), named(args));
        var terminal = new Terminal(utf8(FileDescriptor.out), work.err(), work::done);
        var exitCode = new CommandLineFront(terminal, commands).run(args);
        work.done();
        terminal.out().flush();
        terminal.err().flush();
        System.exit(exitCode.number());
    }

    /**
     * Turns off LWJGL's hash check of extracted libraries, which costs 20 ms of every start; LWJGL extracts them into a
     * folder named by their version.
     */
    private static void trustExtractedLibraries() {
        if (System.getProperty("org.lwjgl.util.NoHashChecks") == null) {
            System.setProperty("org.lwjgl.util.NoHashChecks", "true");
        }
    }

    private static String named(String[] args) {
        return args.length == 0 ? "nephele" : "nephele " + args[0];
    }

    private static PrintStream utf8(FileDescriptor descriptor) {
        return new PrintStream(new FileOutputStream(descriptor), true, StandardCharsets.UTF_8);
    }
}
