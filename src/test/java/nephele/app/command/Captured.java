package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import nephele.host.terminal.Terminal;
import nephele.workshop.Workshop;

/** The exit code and output of a command run in this process. */
public record Captured(int exitCode, String out, String err) {
    /** A record or an exception as Java writes it, which no user should read. */
    private static final Pattern OF_JAVA =
            Pattern.compile("[A-Z]\\w+\\[\\w+=|\\bjavax?\\.[a-z]|\\bnephele\\.[a-z]+\\.|\\w+Exception|\\w+Error\\b");

    /** Runs a command, whose output must be in plain words unless {@code --verbose} asks for more. */
    public static Captured run(String... arguments) {
        Captured answer = runAsItIs(arguments);
        var ofJava = OF_JAVA.matcher(answer.out + answer.err);
        assertFalse(
                !List.of(arguments).contains("--verbose") && ofJava.find(),
                () -> String.join(" ", arguments) + " answers with Java's words: " + answer.out + answer.err);
        return answer;
    }

    private static Captured runAsItIs(String... arguments) {
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        var terminal = new Terminal(stream(out), stream(err));
        int exitCode =
                new CommandLineFront(terminal, Workshop.COMMANDS).run(arguments).number();
        return new Captured(exitCode, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    private static PrintStream stream(ByteArrayOutputStream bytes) {
        return new PrintStream(bytes, true, StandardCharsets.UTF_8);
    }
}
