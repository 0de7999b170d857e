package nephele.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import nephele.app.play.GameLoop;
import nephele.app.play.OffscreenWalk;
import nephele.app.play.PlayRequest;
import nephele.app.play.StartProfile;
import nephele.app.play.WaitingGame;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.view.SceneViewer;
import nephele.app.window.Size;
import nephele.app.window.SystemDisplay;
import nephele.engine.level.PlayerStart;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;
import nephele.host.compare.TechniquePair;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.host.userfile.UserFolders;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;

/** Runs the game; without a display it draws the level's recorded walk offscreen. */
@picocli.CommandLine.Command
final class PlayCommand implements Command {
    private static final Path PICTURES = Path.of("build", "pictures");

    /** Starts timing when the command is created, before its options are read. */
    private final StartProfile profile = new StartProfile();

    @Parameters(
            arity = "0..1",
            paramLabel = "LEVEL",
            description = "A level file (default: the title; without a display, level 01).")
    private String level;

    @Option(
            names = "--from",
            paramLabel = "x,y,z,yawDeg,pitchDeg",
            description = "Begin with the feet here, looking there.")
    private PlayerStart from;

    @Option(names = "--record", paramLabel = "FILE", description = "Keep what is done as a replay.")
    private Path record;

    @Option(
            names = "--ticks-per-second",
            paramLabel = "N",
            description = "The simulation's rate with --record (default: 120).")
    @OptionRange.Whole(least = SimSettings.LEAST_TICKS_PER_SECOND, most = SimSettings.MOST_TICKS_PER_SECOND)
    private Integer ticksPerSecond;

    @Option(
            names = "--assist",
            paramLabel = "NAME",
            split = ",",
            description = "What helps the player: funnel, floor-exit-speed, speed-cap, body-return, portal-to-floor,"
                    + " portal-turn, walk-in, exit-room, safe-return, or none (default: all but speed-cap)."
                    + " Stored with --record; a replay brings its own.")
    private List<String> assists;

    @Option(
            names = "--upright-rate",
            paramLabel = "DEG_PER_SECOND|instant",
            description = {
                "How fast the view turns upright after a portal has left it leaning: 10 or more, or instant",
                "(default: 360). Stored with --record; a replay brings its own."
            })
    private UprightRate uprightRate;

    @Option(names = "--replay", paramLabel = "FILE", description = "Show a replay, at the rate that the file says.")
    private String replay;

    @Option(names = "--take-over", paramLabel = "TICK", description = "With --replay: play from this tick on.")
    @OptionRange.Whole(least = 0, most = Long.MAX_VALUE)
    private Long takeOver;

    @Option(
            names = "--compare",
            paramLabel = "A,B",
            description = {
                "Draw the clouds of LEVEL by two techniques, A left and B right of a wipe that ← and → move:",
                "auto, skybox, skyplane, procedural, billboard, particles, volume."
            })
    private TechniquePair compared;

    @Option(names = "--fullscreen", description = "Begin in full screen (F11 changes it).")
    private boolean fullScreen;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description = "The window or picture in pixels (default: the settings' resolution, else 1280x720).")
    private Size size;

    @Option(
            names = "--profile-start",
            description = "Draw one frame, print where the time since the JVM's start went, and leave.")
    private boolean profileStart;

    /** The editor's way to play: orders come by standard input; a level only warms the process. */
    @Option(names = "--warm", hidden = true)
    private boolean warm;

    @Option(
            names = "--quality",
            paramLabel = "Q",
            description = "low, medium, high, ultra or auto (default: that of the settings, at first auto).")
    private String quality;

    @Option(
            names = "--set",
            paramLabel = "KEY=VALUE",
            parameterConsumer = SettingConsumer.class,
            description = "Change single settings, as in render.")
    private Map<String, String> qualitySettings = new LinkedHashMap<>();

    static Preload preload() {
        return SystemDisplay.isPresent() ? Preload.nothing() : Preload.offscreenGraphics();
    }

    @Override
    public void register(CommandLine commandLine) {
        commandLine.registerConverter(UprightRate.class, PlayCommand::uprightRate);
    }

    @Override
    public ExitCode run(Terminal terminal) throws IOException {
        var request = request(terminal);
        boolean windowed = SystemDisplay.isPresent();
        if (warm && !windowed) {
            throw CommandFailure.environment("to play from the editor, a display is needed: there is none");
        }
        if (warm) {
            terminal.shown().run();
            WaitingGame.run(request, System.in, terminal.out());
        } else if (windowed && profileStart) {
            GameLoop.profileStart(request, profile, terminal.out());
        } else if (windowed) {
            GameLoop.play(request, terminal.shown());
        } else if (profileStart) {
            new OffscreenWalk(request, terminal.out(), PICTURES).profileStart(profile);
        } else {
            new OffscreenWalk(request, terminal.out(), PICTURES).run();
        }
        return ExitCode.DONE;
    }

    private PlayRequest request(Terminal terminal) {
        if (compared != null && (level == null || warm)) {
            throw CommandFailure.usage("--compare needs the LEVEL whose clouds are compared");
        }
        boolean showsTitle = level == null && SystemDisplay.isPresent() && replay == null && from == null;
        var name = showsTitle ? null : level == null ? LevelCatalogue.first() : new LevelName(level);
        var log = terminal.isVerbose() ? terminal.err() : null;
        var files = new PlayerFiles(UserFolders.ofThisUser());
        files.takeProblems().forEach(terminal.err()::println);
        var picture = picture(Settings.resolution(files.settings()));
        return new PlayRequest(
                name,
                from,
                quality(),
                shown(name, terminal),
                record,
                settings(),
                compared,
                picture,
                new PlayRequest.Player(
                        files,
                        log,
                        // A method reference would load the viewer's class, and with it the module of scenes.
                        (file, title, screen, complaints) -> SceneViewer.visit(file, title, screen, complaints)));
    }

    /** Returns the choice of quality; null if no option states one, which leaves it to the player's settings. */
    private QualityChoice quality() {
        if (quality == null && qualitySettings.isEmpty()) {
            return null;
        }
        var choice = new QualityChoice(quality == null ? "auto" : quality, qualitySettings);
        choice.check();
        return choice;
    }

    /** @param chosen by the player's settings; null for none */
    private PlayRequest.Picture picture(Size chosen) {
        Size usual = chosen == null ? Size.DEFAULT : chosen;
        Size pixels = size == null ? usual : size;
        return new PlayRequest.Picture(pixels.width(), pixels.height(), fullScreen);
    }

    private PlayRequest.Shown shown(LevelName name, Terminal terminal) {
        if (replay == null && takeOver != null) {
            throw CommandFailure.usage("--take-over belongs to --replay");
        }
        if (replay == null) {
            return null;
        }
        Replay read = LevelName.replay(replay);
        if (read.levelName() != null || read.levelSha256() != null) {
            name.open().requireRecordedHere(read, replay, terminal.err());
        }
        if (takeOver != null && (takeOver < 0 || takeOver > read.ticks())) {
            throw CommandFailure.usage(
                    "--take-over is a tick of the replay, 0 to " + read.ticks() + ", not " + takeOver);
        }
        return new PlayRequest.Shown(read, takeOver == null ? PlayRequest.Shown.NEVER : takeOver);
    }

    /** Returns the settings of the simulation; null if no option states one. */
    private SimSettings settings() {
        if (replay != null && ticksPerSecond != null) {
            throw CommandFailure.usage("--ticks-per-second and --replay exclude each other");
        }
        if (replay != null && assists != null) {
            throw CommandFailure.usage("--assist and --replay exclude each other: a replay brings its own");
        }
        if (ticksPerSecond != null && record == null) {
            throw CommandFailure.usage("--ticks-per-second belongs to --record; a replay brings its own rate");
        }
        if (replay != null && uprightRate != null) {
            throw CommandFailure.usage("--upright-rate and --replay exclude each other: a replay brings its own");
        }
        if (ticksPerSecond == null && assists == null && uprightRate == null) {
            return null;
        }
        int rate = ticksPerSecond == null ? SimSettings.DEFAULT.ticksPerSecond() : ticksPerSecond;
        int upright =
                uprightRate == null ? SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND : uprightRate.degreesPerSecond();
        return new SimSettings(rate, assists(assists), upright);
    }

    /**
     * Returns the assists named on the command line.
     *
     * @param names {@code null} for the default
     */
    static List<Assist> assists(List<String> names) {
        if (names == null) {
            return Assist.USUAL;
        }
        List<Assist> assists = new ArrayList<>();
        for (String name : names) {
            if (!name.equals("none")) {
                assists.add(assist(name));
            } else if (names.size() > 1) {
                throw CommandFailure.usage("--assist none stands alone");
            }
        }
        return assists;
    }

    private static Assist assist(String name) {
        return Arrays.stream(Assist.values())
                .filter(assist -> assist.text().equals(name))
                .findFirst()
                .orElseThrow(() -> CommandFailure.usage("--assist " + name + ": there is "
                        + Arrays.stream(Assist.values()).map(Assist::text).collect(Collectors.joining(", "))
                        + " and none"));
    }

    /** The rate of {@code --upright-rate}, which may also be a word. */
    record UprightRate(int degreesPerSecond) {}

    private static UprightRate uprightRate(String text) {
        if (text.equals("instant")) {
            return new UprightRate(SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND);
        }
        int rate = text.matches("[0-9]{1,6}") ? Integer.parseInt(text) : 0;
        if (rate < SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND
                || rate > SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND) {
            throw new TypeConversionException("'" + text + "' must be `instant` or whole degrees per second from "
                    + SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND + " to "
                    + SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND);
        }
        return new UprightRate(rate);
    }
}
