package nephele.app.command;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import nephele.app.scenes.OpenedScene;
import nephele.app.terminal.CommandFailure;
import nephele.app.terminal.ExitCode;
import nephele.app.terminal.Terminal;
import nephele.engine.render.Capture;
import nephele.engine.render.fixed.FixedSceneDrawing;
import nephele.engine.render.fixed.LightTerm;
import nephele.engine.render.fixed.SceneLook;
import nephele.engine.render.fixed.Shading;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import org.joml.Matrix4d;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Shows an XML scene: one picture offscreen. */
@picocli.CommandLine.Command
final class SceneCommand implements Command {
    /** How far ahead of the eye an entity rests, along the scene's z axis. */
    private static final double REST_AHEAD = 3;

    @Parameters(index = "0", arity = "0..1", paramLabel = "FILE.xml", description = "A scene.")
    private Path scene;

    @Parameters(index = "1", arity = "0..1", paramLabel = "ENTITY.xml", description = "What is flown about in it.")
    private Path entity;

    @Parameters(
            index = "2",
            arity = "0..1",
            paramLabel = "BACKGROUND",
            description = "A picture that fills the window behind it.")
    private Path background;

    @Option(
            names = "--out",
            paramLabel = "F.png",
            description = "Take one picture offscreen instead of opening a window.")
    private Path out;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            converter = Size.Converter.class,
            description = "Picture in pixels (default: the scene's window).")
    private Size size;

    @Option(
            names = "--time",
            paramLabel = "S",
            defaultValue = "0",
            description = "The scene's clock in seconds (default: 0).")
    private double timeSeconds;

    @Mixin
    private LookOptions look;

    @Mixin
    private CommonOptions common;

    @Override
    public CommonOptions common() {
        return common;
    }

    @Override
    public ExitCode run(Terminal terminal) {
        checkUsage();
        var opened = OpenedScene.of(scene, entity, background, terminal.err()::println);
        var pixels = size != null
                ? size
                : new Size(
                        opened.scene().window().width(), opened.scene().window().height());
        try (var gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, pixels.width(), pixels.height());
                var drawing = FixedSceneDrawing.load(gl, opened.sources())) {
            var view = FixedSceneDrawing.view(opened.scene().eye(), (double) pixels.width() / pixels.height());
            var ahead = new Matrix4d().translation(0, 0, REST_AHEAD);
            drawing.draw(view, timeSeconds, ahead, look.look(), target);
            gl.requireNoError("scene");
            WrittenFile.write(out, file -> Capture.png(target, file));
        }
        return ExitCode.DONE;
    }

    private void checkUsage() {
        if (scene == null || out == null) {
            throw CommandFailure.usage("name a scene and --out F.png");
        }
        if (!out.toString().toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw CommandFailure.usage("--out must end in .png: " + out);
        }
        if (!Double.isFinite(timeSeconds)) {
            throw CommandFailure.usage("--time must be a number of seconds");
        }
    }

    /** How it is shown. */
    static final class LookOptions {
        @Option(names = "--wireframe", description = "Only the edges of triangles.")
        private boolean wireframe;

        @Option(names = "--axes", description = "Show the axes: x red, y green, z blue.")
        private boolean axes;

        @Option(names = "--shading", paramLabel = "S", description = "flat, gouraud or phong (default: gouraud).")
        private Shading shading;

        @Option(
                names = "--light-terms",
                paramLabel = "T",
                split = ",",
                description = "Only these of ambient, diffuse, specular and emissive (default: all).")
        private List<LightTerm> terms;

        SceneLook look() {
            if (wireframe && shading != null && shading != Shading.WIREFRAME) {
                throw CommandFailure.usage("--wireframe and --shading exclude each other");
            }
            var shown = SceneLook.USUAL
                    .with(wireframe ? Shading.WIREFRAME : shading == null ? Shading.GOURAUD : shading)
                    .with(axes ? SceneLook.Axes.SHOWN : SceneLook.Axes.HIDDEN);
            return terms == null ? shown : shown.with(EnumSet.copyOf(terms));
        }
    }
}
