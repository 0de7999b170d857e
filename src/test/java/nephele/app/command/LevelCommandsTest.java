package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import nephele.engine.level.Weather;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.json.LevelJson;
import nephele.engine.render.RenderFeatures;
import nephele.host.terminal.CrashReport;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.ProgramVersion;
import nephele.host.terminal.Terminal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The contract of the commands that read levels and draw nothing. */
class LevelCommandsTest {
    private static final String WALKING = "levels/samples/walking.json";
    private static final String HEAD = "\"format\": \"nephele-level\", \"version\": 1";

    @TempDir
    Path folder;

    private String level(String text) throws IOException {
        return Files.writeString(folder.resolve("level.json"), text).toString();
    }

    @Test
    void explainOfAnEmptyLevelRequiresNothing() throws IOException {
        var explained = Captured.run("explain", level("{" + HEAD + "}"));
        var expected = RenderFeatures.ALL.stream()
                .map(feature -> feature.name() + ": not required")
                .toList();
        assertEquals(expected, explained.out().lines().toList());
        assertEquals(0, explained.exitCode());
    }

    @Test
    void anUnknownLayerIsNamedWithTheKnownOnes() throws IOException {
        String lamp = "{\"id\": \"%s\", \"kind\": \"point\", \"position\": [0, 1, 0], "
                + "\"radiantIntensity\": [1, 1, 1], \"layer\": \"%s\"}";
        String lit = level("{" + HEAD + ", \"lights\": [" + lamp.formatted("a", "hall") + ", "
                + lamp.formatted("b", "den") + "]}");
        String out = folder.resolve("a.png").toString();
        var unknown = Captured.run("render", lit, "--out", out, "--layer", "hall=0", "--layer", "attic=1");
        assertEquals(ExitCode.USAGE.number(), unknown.exitCode());
        assertTrue(unknown.err().contains("'attic'; its layers are hall, den"), unknown.err());
        var negative = Captured.run("render", lit, "--out", out, "--layer", "den=-1");
        assertTrue(
                negative.err().contains("the gain of 'den' must be a number from 0 to 1000, not -1.0"), negative.err());
    }

    @Test
    void explainNamesThePathAndTheReason() {
        var lines = Captured.run("explain", WALKING).out().lines().toList();
        assertTrue(
                lines.stream().anyMatch(line -> line.matches("[a-z.-]+: required by [a-zA-Z.\\[\\]0-9]+: .+")),
                lines.toString());
        assertTrue(
                lines.stream()
                        .limit(lines.size() - 1)
                        .allMatch(line -> line.matches("[a-z.-]+: (not required|required by [^:]+: .+)")),
                lines.toString());
        assertEquals("baked light: none; `bake " + WALKING + " --light` bakes it", lines.get(lines.size() - 1));
    }

    @Test
    void explainSaysWhetherPortalsSlideToFloors() throws IOException {
        for (boolean says : new boolean[] {true, false}) {
            String gun = ", \"portalGun\": {" + (says ? "" : "\"toFloor\": false") + "}";
            String last = Captured.run("explain", level("{" + HEAD + gun + "}"))
                    .out()
                    .lines()
                    .reduce("", (a, b) -> b);
            assertEquals(
                    says
                            ? "portal-to-floor: required by portalGun: its portals slide down to floors"
                            : "portal-to-floor: not required: portalGun.toFloor is false",
                    last);
        }
        var checked = Captured.run("check", level("{" + HEAD + ", \"portalGun\": {\"toFloor\": \"no\"}}"));
        assertEquals(1, checked.exitCode());
        assertTrue((checked.out() + checked.err()).contains("portalGun.toFloor"), checked.out() + checked.err());
    }

    @Test
    void explainPrintsTheCloudsOfAWeatherAsLinesToPaste() throws IOException {
        String environment = ", \"environment\": {\"weather\": \"overcast\", \"weatherSeed\": 5";
        var lines = Captured.run("explain", level("{" + HEAD + environment + "}}"))
                .out()
                .lines()
                .skip(RenderFeatures.ALL.size())
                .toList();
        assertTrue(lines.get(0).startsWith("clouds: weather-scud by technique "), lines.get(0));
        assertTrue(lines.get(1).startsWith("clouds: weather-stratus by technique "), lines.get(1));
        assertEquals("environment.weather: overcast with weatherSeed 5 means these environment.clouds:", lines.get(2));
        assertEquals(5, lines.size());
        var pasted = level("{" + HEAD + ", \"player\": {\"feet\": [0, 0, 0]}, \"environment\": {\"clouds\": ["
                + lines.get(3) + "," + lines.get(4) + "]}}");
        var meant = LevelJson.read("pasted", Files.readAllBytes(Path.of(pasted)));
        assertEquals(WeatherClouds.of(Weather.OVERCAST, 5), meant.environment().clouds());
        var checked = Captured.run("check", pasted);
        assertEquals(0, checked.exitCode(), checked.out());
    }

    @Test
    void checkPrintsFilePathAndMessageOfEveryLevel() throws IOException {
        var bad = level("{" + HEAD + ", \"solids\": [{ \"id\": \"a\", \"kind\": \"box\", \"size\": [1, 1, 0] }]}");
        var checked = Captured.run("check", WALKING, bad);
        assertAll(
                () -> assertEquals(1, checked.exitCode()),
                () -> assertEquals("", checked.err()),
                () -> assertTrue(
                        checked.out().lines().skip(2).allMatch(line -> line.startsWith(bad + ": solids[0].")),
                        checked.out()),
                () -> assertTrue(checked.out().startsWith(WALKING + ": good\n"), checked.out()),
                () -> assertEquals(0, Captured.run("check", WALKING).exitCode()),
                () -> assertEquals(
                        WALKING + ": good\n" + WALKING + ": baked light: none; `bake " + WALKING
                                + " --light` bakes it\n",
                        Captured.run("check", WALKING).out()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"explain", "simulate", "check"})
    void aMissingLevelIsAnInputErrorWithItsName(String command) {
        var answer = Captured.run(command, "no/such/level.json");
        assertEquals(1, answer.exitCode());
        assertTrue((answer.err() + answer.out()).contains("no/such/level.json: "), answer.err());
    }

    @Test
    void aPipeIsNotWaitedFor() throws Exception {
        var pipe = folder.resolve("pipe.json").toString();
        assertEquals(0, new ProcessBuilder("mkfifo", pipe).start().waitFor());
        var answer = Captured.run("check", pipe);
        assertEquals(1, answer.exitCode());
        assertEquals(
                pipe + ": $: cannot be read: it is not a file", answer.out().strip());
    }

    @Test
    void simulatePrintsHashesAtTheRateAskedForAndAtTheLastTick() {
        var lines = Captured.run("simulate", "levels/samples/empty.json", "--every", "70")
                .out()
                .lines()
                .toList();
        assertTrue(lines.stream().allMatch(line -> line.matches("[0-9]+ [0-9a-f]{16}")), lines.toString());
        var ticks = lines.stream().map(line -> line.split(" ")[0]).toList();
        assertEquals(List.of("70", "140", "210", "280", "300"), ticks);
    }

    @Test
    void simulateTwiceGivesTheSameLinesAndDumpsTheLastState() throws IOException {
        var dump = folder.resolve("deep/state.json");
        var first = Captured.run("simulate", "levels/01-courtyard.json", "--every", "1000", "--dump", dump.toString());
        var second = Captured.run("simulate", "levels/01-courtyard.json", "--every", "1000");
        assertEquals(first.out(), second.out());
        var lastHash = first.out().strip().substring(first.out().strip().lastIndexOf(' ') + 1);
        assertTrue(Files.readString(dump).contains(lastHash));
    }

    @Test
    void aReplayThatIsNoneIsAnInputError() throws IOException {
        var replay = level("{}");
        var answer = Captured.run("simulate", WALKING, "--replay", replay);
        assertEquals(1, answer.exitCode());
        assertTrue(answer.err().contains(replay + ": "), answer.err());
    }

    private String replay(String more) throws IOException {
        var text = "{\"format\": \"nephele-replay\", \"version\": 1, \"level\": \"a.json\", " + more
                + "\"inputs\": [{\"ticks\": 2}]}";
        return Files.writeString(folder.resolve("replay.json"), text).toString();
    }

    @Test
    void aReplayOfAnotherLevelIsRefusedWithBothNames() throws IOException {
        var level = level("{" + HEAD + ", \"name\": \"Here\", \"player\": {\"feet\": [0, 0, 0]}}");
        var replay = replay("\"levelName\": \"There\", ");
        var answer = Captured.run("simulate", level, "--replay", replay);
        assertEquals(1, answer.exitCode());
        assertEquals("", answer.out());
        assertTrue(answer.err().startsWith(replay + ": levelName: "), answer.err());
        assertTrue(answer.err().contains("'There'") && answer.err().contains("'Here'"), answer.err());
    }

    @Test
    void aReplayOfTheLevelAsItWasIsAWarning() throws IOException {
        var text = "{" + HEAD + ", \"name\": \"Here\", \"player\": {\"feet\": [0, 0, 0]}}";
        var level = level(text);
        var sha256 = LevelJson.sha256(LevelJson.read("level", text.getBytes(StandardCharsets.UTF_8)));
        var same = Captured.run("simulate", level, "--replay", replay("\"levelSha256\": \"" + sha256 + "\", "));
        assertEquals("", same.err());
        var replay = replay("\"levelName\": \"Here\", \"levelSha256\": \"" + "0".repeat(64) + "\", ");
        var changed = Captured.run("simulate", level, "--replay", replay);
        assertEquals(0, changed.exitCode());
        assertEquals(same.out(), changed.out());
        assertTrue(changed.err().startsWith(replay + ": levelSha256: warning: "), changed.err());
    }

    @Test
    void outputThatCannotBeWrittenIsToldAndNotDone() {
        var err = new ByteArrayOutputStream();
        var full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        var terminal = new Terminal(new PrintStream(full, true), new PrintStream(err, true));
        assertEquals(
                ExitCode.ENVIRONMENT,
                new CommandLineFront(terminal, Commands.ALL).run("simulate", WALKING, "--every", "9999"));
        assertTrue(
                err.toString(StandardCharsets.UTF_8).startsWith("nephele: the output is incomplete"), err.toString());
        assertEquals(ExitCode.ENVIRONMENT, new CommandLineFront(terminal, Commands.ALL).run("--help"));
        assertEquals(ExitCode.USAGE, new CommandLineFront(terminal, Commands.ALL).run("no-such-command"));
    }

    @Test
    void aCrashWritesAReportWithoutHomePathsAndNoStackTraceToTheTerminal() throws IOException {
        var home = System.getProperty("user.home");
        var failure = new IllegalStateException("broken below " + home + "/secret");
        var text = new CrashReport(List.of("play", home + "/level.json"), Instant.EPOCH, failure).text();
        assertFalse(text.contains(home), text);
        assertTrue(text.contains("program   " + ProgramVersion.line()), text);
        assertTrue(text.contains("~/secret") && text.contains("~/level.json"), text);
    }
}
