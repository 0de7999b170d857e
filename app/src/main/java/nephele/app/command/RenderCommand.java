package nephele.app.command;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntFunction;
import nephele.engine.level.Billboards;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.appearance.WeatherCourse;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.engine.render.Capture;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import nephele.host.playthrough.ObserverView;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Saves one offscreen picture: drawn as the game draws it, or traced by the reference path tracer. */
@picocli.CommandLine.Command
final class RenderCommand implements Command {
    private static final int MOST_GAIN = 1000;

    @Parameters(arity = "0..1", paramLabel = "LEVEL", description = "A level file.")
    private String level;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            required = true,
            description = "F.png, as seen, or F.pfm, linear radiance before exposure and tone curve.")
    private Path out;

    @Option(names = "--camera", paramLabel = "ID", description = "One of the level's cameras.")
    private String camera;

    @Option(names = "--eye", paramLabel = "x,y,z", description = "Look from here; needs --target.")
    private Vec3 eye;

    @Option(names = "--target", paramLabel = "x,y,z", description = "Look at this point; needs --eye.")
    private Vec3 target;

    @Option(
            names = "--fov",
            paramLabel = "DEG",
            description = "Horizontal field of view with --eye (default: the player's).")
    @OptionRange.Decimal(least = 1, most = 170, unit = "degrees")
    private Double fovDegrees;

    @Mixin
    private PictureOptions picture;

    @Option(
            names = "--time",
            paramLabel = "S",
            defaultValue = "0",
            description = "The environment's clock in seconds (default: 0).")
    @OptionRange.Decimal(least = 0, most = Environment.MOST_SECONDS, unit = "seconds")
    private double timeSeconds;

    @Option(names = "--technique", paramLabel = "NAME", description = "Draw all clouds with this technique.")
    private CloudTechnique technique;

    @Option(
            names = "--layer",
            paramLabel = "NAME=GAIN",
            description = "Dim the lights of a layer, and what they have lit: 0 for dark. May be repeated.")
    private Map<String, Double> gains = Map.of();

    @Mixin
    private ReferenceOptions reference;

    @Option(
            names = "--frames",
            paramLabel = "N",
            description =
                    "Draw N frames at the same time and save the last (default: as many as antialiasing averages, or"
                            + " 1).")
    @OptionRange.Whole(least = 1, most = 10_000)
    private Integer frames;

    @Override
    public ExitCode run(Terminal terminal) {
        checkUsage();
        if (reference.isMerge()) {
            reference.merge(out);
            return ExitCode.DONE;
        }
        var opened = byTechnique(new LevelName(level).open());
        checkLayers(opened);
        opened.notice().ifPresent(terminal.err()::println);
        var viewpoint = viewpoint(opened);
        ignored(opened).ifPresent(terminal.err()::println);
        picture.unmetered(opened).ifPresent(terminal.err()::println);
        if (reference.isAsked()) {
            var viewed = reference.exposed(
                    new ReferenceOptions.ViewedLevel(dimmed(opened), viewpoint.apply(0), timeSeconds), picture);
            reference.trace(viewed, picture, out, radiance -> save(radiance, viewed.opened()), terminal);
            return ExitCode.DONE;
        }
        try (var gl = GlContext.offscreen();
                var target = picture.target(gl);
                var renderer = opened.reporting(() -> renderer(opened, gl, terminal))) {
            var state = FrameState.atStart(renderer.scene().level());
            state.seconds(timeSeconds);
            state.layerGains(gains);
            observe(renderer, state);
            int drawn = frames == null ? renderer.framesToSettle() : frames;
            for (int frame = 0; frame < drawn; frame++) {
                renderer.draw(viewpoint.apply(0), state, target);
            }
            gl.requireNoError("render");
            save(renderer, target);
        }
        return ExitCode.DONE;
    }

    /** Colours the sphere of an observer at its start by what it touches. */
    private static void observe(Renderer renderer, FrameState state) {
        var scene = renderer.scene();
        ObserverView observer = ObserverView.of(scene.level(), scene.statics().models());
        if (observer != null && state.observer() != null) {
            state.observer(observer.at(state.observer().centre()));
        }
    }

    private void checkLayers(OpenedLevel opened) {
        List<String> known = opened.level().lights().stream()
                .map(Light::layer)
                .filter(Objects::nonNull)
                .distinct()
                .toList();
        for (var entry : gains.entrySet()) {
            if (!known.contains(entry.getKey())) {
                throw CommandFailure.usage("--layer: no light of this level is in a layer '" + entry.getKey() + "'; "
                        + (known.isEmpty() ? "it has no layers" : "its layers are " + String.join(", ", known)));
            }
            if (!(entry.getValue() >= 0 && entry.getValue() <= MOST_GAIN)) {
                throw CommandFailure.usage("--layer: the gain of '" + entry.getKey() + "' must be a number from 0 to "
                        + MOST_GAIN + ", not " + entry.getValue());
            }
        }
    }

    /** Returns the level with its lights as bright as the gains of their layers make them. */
    private OpenedLevel dimmed(OpenedLevel opened) {
        Level written = opened.level();
        List<Light> lights = written.lights().stream()
                .map(light -> light.dimmed(light.layer() == null ? 1 : gains.getOrDefault(light.layer(), 1.0)))
                .toList();
        return new OpenedLevel(new LevelFile.Opened(
                opened.file(), written.with(written.environment(), lights), opened.assets(), opened.notice()));
    }

    private OpenedLevel byTechnique(OpenedLevel opened) {
        if (technique == null) {
            return opened;
        }
        Level written = opened.level();
        Environment drawn = WeatherClouds.drawnBy(written.environment(), technique);
        return new OpenedLevel(new LevelFile.Opened(
                opened.file(), written.with(drawn, written.lights()), opened.assets(), opened.notice()));
    }

    private Renderer renderer(OpenedLevel opened, GlContext gl, Terminal terminal) {
        return picture.renderer(opened, gl, isPfm() ? Output.HDR : null, terminal.err());
    }

    /** Returns a notice for options without effect: nothing moves. */
    private Optional<String> ignored(OpenedLevel opened) {
        var options = new ArrayList<String>();
        if (timeSeconds != 0 && !follows(opened.level())) {
            options.add("--time");
        }
        if (technique != null && WeatherClouds.all(opened.level().environment()).isEmpty()) {
            options.add("--technique");
        }
        return options.isEmpty()
                ? Optional.empty()
                : Optional.of("nothing in this level follows " + String.join(" or ", options));
    }

    private static boolean follows(Level level) {
        Environment environment = level.environment();
        return !level.emitters().isEmpty()
                || level.billboards().stream().anyMatch(Billboards::moves)
                || environment.hasLightning()
                || Daylight.moves(environment)
                || WeatherCourse.of(environment).changes()
                || WeatherClouds.all(environment).stream()
                        .anyMatch(cloud -> !cloud.motion().equals(Cloud.Motion.STILL));
    }

    private void checkUsage() {
        if (!isPfm() && !lowerCaseName().endsWith(".png")) {
            throw CommandFailure.usage("--out must end in .png or .pfm: " + out);
        }
        if (isPfm() && picture.output() != null && picture.output() != Output.HDR) {
            throw CommandFailure.usage("a PFM holds linear radiance: leave --output out or say hdr");
        }
        picture.check();
        reference.check(out);
        if ((level == null) != reference.isMerge()) {
            throw CommandFailure.usage(level == null ? "name the LEVEL to draw" : "--merge needs no LEVEL: " + level);
        }
    }

    private void save(float[] radiance, OpenedLevel opened) {
        int width = picture.size().width();
        WrittenFile.write(out, file -> {
            if (isPfm()) {
                Capture.pfm(radiance, width, picture.size().height(), file);
            } else {
                var environment = opened.level().environment();
                Capture.png(Capture.toneMapped(radiance, width, environment, picture.output(opened)), file);
            }
        });
    }

    private void save(Renderer renderer, RenderTarget target) {
        WrittenFile.write(out, file -> {
            if (isPfm()) {
                Capture.pfm(
                        renderer.readRadianceOf(target),
                        picture.size().width(),
                        picture.size().height(),
                        file);
            } else {
                Capture.png(target, file);
            }
        });
    }

    private boolean isPfm() {
        return lowerCaseName().endsWith(".pfm");
    }

    private String lowerCaseName() {
        return out.toString().toLowerCase(Locale.ROOT);
    }

    private IntFunction<View> viewpoint(OpenedLevel opened) {
        double aspect = picture.aspect();
        if ((eye == null) != (target == null)) {
            throw CommandFailure.usage("--eye and --target need each other");
        }
        if (eye == null && fovDegrees != null) {
            throw CommandFailure.usage("--fov needs --eye and --target");
        }
        if (eye != null) {
            if (camera != null) {
                throw CommandFailure.usage("--camera and --eye exclude each other");
            }
            var view = Viewpoints.between(eye, target, fovDegrees, aspect);
            return frame -> view;
        }
        return camera == null
                ? Viewpoints.standard(opened.level(), opened.file(), aspect)
                : Viewpoints.named(opened.level(), opened.file(), camera, aspect);
    }
}
