package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
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
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import nephele.app.Main;
import nephele.app.VirtualDisplay;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.play.hud.MenuPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * A player with an empty home begins at the title, changes a setting, finishes a level, goes on to the next one, leaves,
 * and later continues: with a real window, real keys and a real pointer.
 */
@Execution(ExecutionMode.SAME_THREAD)
class CampaignSwingTest {
    private static final long LONGEST_SECONDS = 60;
    private static final String PROGRESS = ".local/state/nephele/progress.json";
    private static final Path HERE = Path.of("").toAbsolutePath();
    private static final Path PICTURES = Path.of("build", "pictures", "campaign");

    /** A tick of level 02's recording about 5 m before the exit. */
    private static final int TAKE_OVER = 1660;

    @TempDir
    Path home;

    private final List<Process> started = new ArrayList<>();
    private VirtualDisplay display;
    private PrintStream commands;
    private BufferedReader answers;

    @BeforeEach
    void begin() throws IOException {
        Files.createDirectories(PICTURES);
        display = VirtualDisplay.start();
        Process robot =
                start(HERE, ProcessBuilder.Redirect.DISCARD, "-Djava.awt.headless=false", RobotHands.class.getName());
        commands = new PrintStream(robot.getOutputStream(), true, StandardCharsets.UTF_8);
        answers = new BufferedReader(new InputStreamReader(robot.getInputStream(), StandardCharsets.UTF_8));
    }

    @AfterEach
    void end() {
        started.forEach(Process::destroyForcibly);
        display.close();
    }

    /** Returns the class path for processes in any folder, without the project's own, where levels would be found. */
    private static String classPath() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(entry -> !entry.equals("."))
                .map(entry -> Path.of(entry).toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator));
    }

    private Process start(Path folder, ProcessBuilder.Redirect errors, String... words) throws IOException {
        var command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx512m",
                "-XX:TieredStopAtLevel=1", // it lives for seconds
                "-XX:+UseSerialGC",
                "-Djoml.nounsafe=true",
                "-cp",
                classPath()));
        Collections.addAll(command, words);
        var builder = new ProcessBuilder(command).directory(folder.toFile()).redirectError(errors);
        builder.environment().put("DISPLAY", display.name());
        builder.environment().put("HOME", home.toString());
        List.of("WAYLAND_DISPLAY", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME")
                .forEach(builder.environment()::remove);
        Process process = builder.start();
        started.add(process);
        return process;
    }

    private void hand(String command) throws IOException {
        commands.println(command);
        assertEquals("ok", answers.readLine(), command);
    }

    /** A running game and the lines that it writes. */
    private final class Game {
        private final Process process;
        private final LinkedBlockingQueue<String> lines = new LinkedBlockingQueue<>();

        Game(String... words) throws IOException {
            this(HERE, words);
        }

        /** @param folder whose levels are the campaign */
        Game(Path folder, String... words) throws IOException {
            var all = new ArrayList<>(List.of(Main.class.getName(), "play"));
            Collections.addAll(all, words);
            Collections.addAll(all, "--size", "640x360", "--quality", "low", "--verbose");
            process = start(folder, ProcessBuilder.Redirect.PIPE, all.toArray(String[]::new));
            var reader = new BufferedReader(new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8));
            var thread = new Thread(
                    () -> reader.lines()
                            .filter(line -> !line.contains(": at work for "))
                            .forEach(lines::add),
                    "lines of the game");
            thread.setDaemon(true);
            thread.start();
        }

        /** Waits for the next state, which has to be this one. */
        void expect(String state) throws InterruptedException {
            String line = lines.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
            assertNotNull(line, "no line, expected " + state);
            assertTrue(line.startsWith("state " + state), line + " instead of " + state);
        }

        void expectEnd() throws InterruptedException {
            assertTrue(process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS), "the game still runs");
            assertEquals(0, process.exitValue(), lines.toString());
        }
    }

    /** Returns the middle of the first entry of the page after a level. */
    private static int firstEntry() {
        var entries = Collections.nCopies(5, new Entry("entry", Choice.Plain.QUIT));
        var menu = new Menu("ended", "First shot", List.of("time", "portals"), entries, 0, 0, null, "");
        var panel = new MenuPanel(menu, new Area(640, 360));
        int top = 0;
        while (panel.rowAt(320, top) != 0) {
            top++;
        }
        int bottom = top;
        while (panel.rowAt(320, bottom) == 0) {
            bottom++;
        }
        return (top + bottom) / 2;
    }

    /** Returns the folder of a game whose first level has the exit some steps ahead, and whose second is 03. */
    private Path nearTheExit() throws IOException {
        Path levels = Files.createDirectories(home.resolve("game").resolve("levels"));
        Files.createSymbolicLink(levels.resolveSibling("assets"), HERE.resolve("assets"));
        Files.copy(HERE.resolve("levels/03-momentum.json"), levels.resolve("03-momentum.json"));
        // The light of the real 02 would be that of another version of this one, and said to be so.
        Path baked = Files.createDirectory(levels.resolve("baked"));
        try (var files = Files.newDirectoryStream(HERE.resolve("levels/baked"), "sky-*")) {
            for (Path file : files) {
                Files.createSymbolicLink(baked.resolve(file.getFileName()), file);
            }
        }
        Files.writeString(
                levels.resolve("campaign.json"),
                """
                {"format": "nephele-campaign", "version": 1, "levels": ["02-first-shot.json", "03-momentum.json"]}""");
        Files.writeString(
                levels.resolve("02-first-shot.json"),
                """
                {
                  "format": "nephele-level",
                  "version": 1,
                  "environment": { "ambient": [0.5, 0.5, 0.5] },
                  "player": { "feet": [0, 0, 3] },
                  "solids": [{ "id": "floor", "kind": "box", "centre": [0, -0.5, 0], "size": [9, 1, 9] }],
                  "exits": [{ "id": "end", "feet": [0, 0, 0], "heightMetres": 2.2 }]
                }
                """);
        return levels.getParent();
    }

    private String kept(String file) throws IOException {
        return Files.readString(home.resolve(file));
    }

    @Test
    void fromTheTitleToTheNextLevelAndBack() throws Exception {
        Game first = new Game();
        first.expect("title");
        hand("picture " + PICTURES.resolve("1-title.png"));
        for (int i = 0; i < 4; i++) {
            hand("key DOWN");
        }
        hand("key ENTER");
        first.expect("menu settings");
        hand("key RIGHT");
        hand("picture " + PICTURES.resolve("2-settings.png"));
        hand("key ESCAPE");
        first.expect("title");
        hand("key DOWN");
        hand("key ENTER");
        first.expectEnd();
        assertTrue(kept(".config/nephele/settings.json").contains("\"language\": \"pt-br\""));

        Game second = new Game(
                "levels/02-first-shot.json",
                "--replay",
                "levels/replays/02-first-shot.json",
                "--take-over",
                Integer.toString(TAKE_OVER));
        second.expect("loading 02-first-shot.json");
        second.expect("playing 02-first-shot.json");
        hand("down W");
        second.expect("exit 02-first-shot.json");
        hand("up W");
        second.expect("menu ended");
        hand("picture " + PICTURES.resolve("3-practice.png"));
        hand("key UP");
        hand("key ENTER");
        second.expectEnd();
        assertFalse(
                Files.exists(home.resolve(PROGRESS))
                        && Files.readString(home.resolve(PROGRESS)).contains("levels"),
                "a replay that was taken over is no progress, though who walks learns to");

        Game byHand = new Game(nearTheExit(), "levels/02-first-shot.json");
        byHand.expect("loading 02-first-shot.json");
        byHand.expect("playing 02-first-shot.json");
        hand("down W");
        byHand.expect("exit 02-first-shot.json");
        hand("up W");
        byHand.expect("menu ended");
        hand("picture " + PICTURES.resolve("3-end.png"));
        hand("click 320 " + firstEntry());
        byHand.expect("loading 03-momentum.json");
        byHand.expect("playing 03-momentum.json");
        hand("picture " + PICTURES.resolve("4-next.png"));
        hand("key ESCAPE");
        byHand.expect("menu pause");
        hand("key UP");
        hand("key ENTER");
        byHand.expectEnd();
        assertTrue(kept(PROGRESS).contains("\"02-first-shot.json\""));

        Game third = new Game();
        third.expect("title");
        hand("picture " + PICTURES.resolve("5-again.png"));
        hand("key ENTER");
        String loadingOrPlaying = third.lines.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
        if (!"state playing 01-courtyard.json".equals(loadingOrPlaying)) {
            assertEquals("state loading 01-courtyard.json", loadingOrPlaying);
            third.expect("playing 01-courtyard.json");
        }
        hand("key ESCAPE");
        third.expect("menu pause");
        hand("picture " + PICTURES.resolve("6-pause.png"));
        hand("key UP");
        hand("key ENTER");
        third.expectEnd();
    }
}
