package nephele.app.command;

import java.util.stream.IntStream;
import nephele.engine.measure.FrameTimes;
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
            arity = "0..1",
            paramLabel = "LEVEL",
            description = "A level file or an XML scene; none with --calibrate.")
    private String level;

    @Option(names = "--calibrate", description = "Measure one full-screen bilinear quad instead of a level.")
    private boolean calibrate;

    @Option(names = "--per-pass", description = "Time each pass as well, and say with which clock.")
    private boolean perPass;

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
        if ((level == null) != calibrate) {
            throw CommandFailure.usage("name a level, or say --calibrate");
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
        } else if (level.endsWith(".xml")) {
            measureScene(terminal);
        } else {
            measure(new LevelName(level).open(), terminal);
        }
        return ExitCode.DONE;
    }

    private void calibrate(Terminal terminal) {
        try (var gl = GlContext.offscreen();
                var drawing = new CalibrationDrawing(
                        gl, picture.size().width(), picture.size().height())) {
            print(new Bench(gl).measure(drawing), terminal);
        }
    }

    private void measureScene(Terminal terminal) {
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
                drawing.passTimes(gl).forEach(terminal.out()::println);
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
