package nephele.app.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import nephele.engine.measure.FrameTimes;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.lab.bench.Bench;
import nephele.lab.bench.CalibrationDrawing;
import nephele.lab.bench.Drawing;
import nephele.lab.bench.LevelDrawing;
import nephele.lab.bench.PassCosts;
import nephele.lab.bench.SceneDrawing;
import nephele.scenes.file.OpenedScene;
import nephele.scenes.file.SceneName;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.SceneAppearance;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Measures a level's frames and prints CSV. */
@picocli.CommandLine.Command
final class BenchCommand implements Command {
    @Parameters(
            arity = "0..*",
            paramLabel = "LEVEL",
            description = "A level file or an XML scene; none with --calibrate; several with --every-camera.")
    private List<String> levels = List.of();

    @Option(names = "--calibrate", description = "Measure one full-screen bilinear quad instead of a level.")
    private boolean calibrate;

    @Option(names = "--per-pass", description = "Time each pass as well, and say with which clock.")
    private boolean perPass;

    @Option(
            names = "--every-camera",
            description = "Print a table in Markdown: each camera of the levels at each preset, pass by pass,"
                    + " scaled to a machine that takes 5.8 ms for --calibrate.")
    private boolean everyCamera;

    @Option(names = "--bare", description = "Measure the bare OpenGL twin instead of the engine.")
    private boolean bare;

    @Option(
            names = "--frames",
            paramLabel = "N",
            description = "Frames of one round (default: the length of the camera's path).")
    @OptionRange.Whole(least = 1, most = 10_000)
    private Integer frames;

    @Option(names = "--camera", paramLabel = "ID", description = "A camera of the level (default: the first).")
    private String camera;

    @Mixin
    private PictureOptions picture;

    @Override
    public ExitCode run(Terminal terminal) {
        if (levels.isEmpty() != calibrate) {
            throw CommandFailure.usage("name a level, or say --calibrate");
        }
        if (levels.size() > 1 && !everyCamera) {
            throw CommandFailure.usage("name one level, or say --every-camera");
        }
        if (everyCamera && (bare || perPass || camera != null || frames != null || calibrate)) {
            throw CommandFailure.usage(
                    "--every-camera chooses what it measures: leave --bare, --per-pass, --camera and --frames out");
        }
        if (bare && perPass) {
            throw CommandFailure.usage("the bare twin has no passes: leave --per-pass or --bare out");
        }
        if (calibrate && camera != null) {
            throw CommandFailure.usage("--calibrate draws no level: leave --camera out");
        }
        picture.check();
        if (calibrate) {
            calibrate(terminal);
        } else if (everyCamera) {
            measureEveryCamera(terminal);
        } else if (levels.get(0).endsWith(".xml")) {
            measureScene(levels.get(0), terminal);
        } else {
            measure(new LevelName(levels.get(0)).open(), terminal);
        }
        return ExitCode.DONE;
    }

    private void calibrate(Terminal terminal) {
        try (var gl = GlContext.offscreen()) {
            print(calibration(gl), terminal);
        }
    }

    private FrameTimes calibration(GlContext gl) {
        try (var drawing = new CalibrationDrawing(
                gl, picture.size().width(), picture.size().height())) {
            return new Bench(gl).measure(drawing);
        }
    }

    private void measureEveryCamera(Terminal terminal) {
        var opened = levels.stream().map(level -> new LevelName(level).open()).toList();
        try (var gl = GlContext.offscreen()) {
            double scale = CalibrationDrawing.USUAL_MS / calibration(gl).cpuMsMean();
            terminal.out().println(PassCosts.TABLE_HEADER);
            for (var level : opened) {
                for (var preset : Quality.Preset.values()) {
                    rows(gl, level, preset.name().toLowerCase(Locale.ROOT), scale)
                            .forEach(terminal.out()::println);
                }
            }
        }
    }

    private List<String> rows(GlContext gl, OpenedLevel opened, String quality, double scale) {
        var rows = new ArrayList<String>();
        try (var renderer =
                        opened.reporting(() -> picture.renderer(opened, gl, picture.at(quality), null, System.err));
                var target = picture.target(gl)) {
            for (var each : opened.level().cameras()) {
                var view = Viewpoints.named(opened.level(), opened.file(), each.id(), picture.aspect())
                        .apply(0);
                var costs = PassCosts.of(gl, new LevelDrawing(renderer, List.of(view), target));
                rows.add(costs.row(opened.file(), each.id(), quality, scale));
            }
        }
        return rows;
    }

    private void measureScene(String level, Terminal terminal) {
        if (perPass || camera != null) {
            throw CommandFailure.usage("an XML scene has no passes and one camera: leave --per-pass and --camera out");
        }
        var opened = OpenedScene.of(new SceneName(level), null, null, terminal.err()::println);
        var view = FixedSceneDrawing.view(opened.scene().eye(), picture.aspect());
        try (var gl = GlContext.offscreen();
                var drawing = new SceneDrawing(
                        gl,
                        FixedSceneDrawing.load(gl, opened.sources()),
                        view,
                        SceneAppearance.USUAL,
                        picture.target(gl),
                        frames == null ? 1 : frames)) {
            print(times(gl, drawing), terminal);
            gl.requireNoError("bench");
        }
    }

    private void measure(OpenedLevel opened, Terminal terminal) {
        picture.unmetered(opened).ifPresent(terminal.err()::println);
        try (var gl = GlContext.offscreen();
                var drawing = opened.reporting(() -> drawing(opened, gl))) {
            print(times(gl, drawing), terminal);
            gl.requireNoError("bench");
            if (perPass) {
                PassCosts.of(gl, drawing).csv().forEach(terminal.out()::println);
            }
        }
    }

    private FrameTimes times(GlContext gl, Drawing engine) {
        if (!bare) {
            return new Bench(gl).measure(engine);
        }
        try (var twin = engine.bareTwin(gl)) {
            return new Bench(gl).measure(twin);
        }
    }

    private LevelDrawing drawing(OpenedLevel opened, GlContext gl) {
        var viewpoint = camera == null
                ? Viewpoints.standard(opened.level(), opened.file(), picture.aspect())
                : Viewpoints.named(opened.level(), opened.file(), camera, picture.aspect());
        var views = IntStream.range(0, roundLength(opened))
                .mapToObj(viewpoint::apply)
                .toList();
        var renderer = picture.renderer(opened, gl, null, System.err);
        try {
            return new LevelDrawing(renderer, views, picture.target(gl));
        } catch (RuntimeException e) {
            renderer.close();
            throw e;
        }
    }

    private int roundLength(OpenedLevel opened) {
        if (frames != null) {
            return frames;
        }
        return opened.level().cameras().stream()
                .filter(each -> camera == null || camera.equals(each.id()))
                .findFirst()
                .map(each -> Math.max(1, each.path().size()))
                .orElse(1);
    }

    private static void print(FrameTimes times, Terminal terminal) {
        terminal.out().println(FrameTimes.HEADER);
        terminal.out().println(times.csv());
    }
}
