package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import nephele.app.Main;
import nephele.app.VirtualDisplay;
import nephele.app.play.RobotHands;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.host.named.LevelName;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The waiting game on a display of its own, played with real keys. */
@Execution(ExecutionMode.SAME_THREAD)
class WarmGameSwingTest {
    private static final long LONGEST_SECONDS = 60;

    @TempDir
    Path folder;

    private final GameNotes notes = new GameNotes();
    private VirtualDisplay display;
    private Process robot;
    private PrintStream commands;
    private BufferedReader answers;
    private WarmGame game;

    @BeforeEach
    void begin() throws IOException {
        display = VirtualDisplay.start();
        var words = java("-Djava.awt.headless=false", RobotHands.class.getName());
        robot = new ProcessBuilder(words)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        commands = new PrintStream(robot.getOutputStream(), true, StandardCharsets.UTF_8);
        answers = new BufferedReader(new InputStreamReader(robot.getInputStream(), StandardCharsets.UTF_8));
        game = new WarmGame(
                () -> java(Main.class.getName(), "play", "--warm", "--size", "320x180", "--quality", "low"), notes);
    }

    @AfterEach
    void end() {
        game.close();
        robot.destroyForcibly();
        display.close();
    }

    private List<String> java(String... words) {
        var all = new ArrayList<>(List.of(
                "env",
                "-u",
                "WAYLAND_DISPLAY",
                "DISPLAY=" + display.name(),
                "HOME=" + folder,
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djoml.nounsafe=true",
                "-cp",
                System.getProperty("java.class.path").replace(File.pathSeparator + ".", "")));
        all.addAll(WarmGame.JAVA_OPTIONS);
        Collections.addAll(all, words);
        return all;
    }

    /** Returns the next note that is not of progress. */
    private Object next() throws InterruptedException {
        Object next = notes.next();
        while (next.toString().startsWith("baking ")) {
            assertNotEquals("baking 0", next);
            next = notes.next();
        }
        return next;
    }

    private PlayEnd ended() throws InterruptedException {
        Object next = next();
        assertTrue(next instanceof PlayEnd, next.toString());
        return (PlayEnd) next;
    }

    private void hand(String command) throws IOException {
        commands.println(command);
        assertEquals("ok", answers.readLine(), command);
    }

    /** Returns a floor with an exit 3 m before the player, or none. */
    private static Level level(String exits) {
        String text = "{\"format\": \"nephele-level\", \"version\": 1, \"player\": {\"feet\": [0, 0, 0]},"
                + " \"environment\": {\"sky\": {\"kind\": \"constant\", \"radiance\": [1, 1, 1]}},"
                + " \"materials\": [{\"id\": \"m\"}], \"exits\": [" + exits + "], \"solids\": [{\"id\": \"floor\","
                + " \"kind\": \"box\", \"material\": \"m\", \"centre\": [0, -0.5, 0], \"size\": [60, 1, 60]}]}";
        return LevelJson.read("level", text.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void oneProcessPlaysSnapshotAfterSnapshotAndEndsWithItsEditor() throws Exception {
        Path file = folder.resolve("unsaved.json");
        game.warm();
        assertEquals("ready", next());
        long process = game.processId().orElseThrow();

        var from = new PlayerStart(new Vec3(2, 0, 5), 90, -10);
        game.play(new WarmGame.Request(level(""), file, from, null, null));
        assertEquals("playing", next());
        hand("key ESCAPE");
        PlayEnd first = ended();
        assertEquals(from.yawDegrees(), first.player().yawDegrees(), 1e-6);
        assertEquals(2, first.player().feet().x(), 0.01);
        assertFalse(first.exitReached());
        assertNull(first.recorded());

        Path solution = SolutionCheck.fileOf(file);
        var exit = level("{\"id\": \"e\", \"feet\": [0, 0, -3], \"heightMetres\": 2}");
        game.play(new WarmGame.Request(exit, file, null, null, solution));
        assertEquals("playing", next());
        hand("down W");
        PlayEnd second = ended();
        hand("up W");
        assertTrue(second.exitReached());
        assertEquals(solution.toString(), second.recorded());
        assertTrue(LevelName.replay(second.recorded()).track().size() > 1);

        game.play(new WarmGame.Request(exit, file, null, "gigantic", null));
        Object failed = next();
        assertTrue(failed.toString().startsWith("failed: --quality is"), failed.toString());
        assertEquals(process, game.processId().orElseThrow());
        game.close();
        assertTrue(ProcessHandle.of(process)
                .map(ProcessHandle::onExit)
                .map(exited ->
                        exited.orTimeout(LONGEST_SECONDS, TimeUnit.SECONDS).join())
                .map(ended -> !ended.isAlive())
                .orElse(true));
        assertEquals(List.of(), notes.rest());
        try (var left = Files.list(folder)) {
            assertTrue(left.noneMatch(path -> path.toString().endsWith("unsaved.json")));
        }
    }
}
