package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.stream.Stream;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class CommandLineFrontTest {
    static Stream<String> commandNames() {
        return Commands.ALL.stream().map(CommandEntry::name);
    }

    @ParameterizedTest
    @MethodSource("commandNames")
    void everyCommandAnswersHelp(String name) {
        var help = Captured.run(name, "--help");
        assertAll(
                () -> assertEquals(0, help.exitCode()),
                () -> assertTrue(help.out().contains("nephele " + name), help.out()),
                () -> assertEquals("", help.err()));
    }

    @ParameterizedTest
    @MethodSource("commandNames")
    void theOverviewListsEveryCommand(String name) {
        assertTrue(Captured.run("--help").out().contains("\n  " + name + " "));
    }

    @Test
    void aTypingErrorIsWrongUsageAndGetsAProposal() {
        var answer = Captured.run("pley");
        assertEquals(2, answer.exitCode());
        assertTrue(answer.err().contains("did you mean `play`"), answer.err());
        assertFalse(Captured.run("xyzzy").err().contains("did you mean"));
    }

    @ParameterizedTest
    @CsvSource({
        "play --fulscreen, --fullscreen",
        "render levels/01-courtyard.json --out x.png --sise=8x8, --size",
        "bench --calibate, --calibrate"
    })
    void aMistypedOptionGetsAProposal(String line, String meant) {
        var answer = Captured.run(line.split(" "));
        assertEquals(2, answer.exitCode());
        assertTrue(answer.err().contains("did you mean `" + meant + "`?"), answer.err());
        assertFalse(Captured.run("play", "--xyzzy").err().contains("did you mean"));
    }

    @Test
    void theVersionIsALine() {
        var answer = Captured.run("--version");
        assertEquals(0, answer.exitCode());
        assertTrue(answer.out().matches("nephele .+, Java 1.+\\n"), answer.out());
    }

    @Test
    void noCommandIsWrongUsage() {
        assertEquals(2, Captured.run().exitCode());
    }

    @ParameterizedTest
    @MethodSource("wrongUsages")
    void wrongUsageNamesTheCommandAndTheOption(String line, String named) {
        var answer = Captured.run(line.split(" "));
        assertAll(
                () -> assertEquals(2, answer.exitCode(), answer.err()),
                () -> assertTrue(answer.err().contains(named), answer.err()),
                () -> assertEquals("", answer.out()),
                () -> assertFalse(answer.err().contains("Exception"), answer.err()));
    }

    static Stream<Arguments> wrongUsages() {
        return Stream.of(
                        "play x.json --compare volume|--compare",
                        "play x.json --compare volume,puffs|billboard, particles, volume",
                        "play --compare volume,particles|--compare",
                        "prove --nonsense|--nonsense",
                        "prove no-such-proof|no-such-proof",
                        "prove --count x|--count",
                        "prove --count 0|--count")
                .map(line -> Arguments.of((Object[]) line.split("\\|")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"prove", "prove --list", "prove rotations --count 1"})
    void theJarSaysWhereProofsRun(String line) {
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        var terminal = new Terminal(new PrintStream(out, true), new PrintStream(err, true));
        assertEquals(ExitCode.ENVIRONMENT, new CommandLineFront(terminal, Commands.ALL).run(line.split(" ")));
        assertEquals("", out.toString());
        assertTrue(err.toString().contains("./nephele prove"), err.toString());
    }
}
