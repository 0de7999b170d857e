package nephele.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.view.SceneViewer;
import nephele.app.window.Size;
import nephele.app.window.SystemDisplay;
import nephele.engine.level.Environment;
import nephele.engine.level.Language;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.host.userfile.UserFolders;
import nephele.scenes.file.OpenedScene;
import nephele.scenes.file.SceneName;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.LightTerm;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.Shading;
import nephele.scenes.view.OffscreenTour;
import nephele.scenes.view.SceneStart;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Shows an XML scene in a window, or saves pictures of it offscreen. */
@picocli.CommandLine.Command
final class SceneCommand implements Command {
    private static final Path PICTURES = Path.of("build", "pictures");

    @Parameters(
            index = "0",
            arity = "0..1",
            paramLabel = "FILE.xml",
            description = "A scene (default: a solar system).")
    private String scene;

    @Parameters(index = "1", arity = "0..1", paramLabel = "ENTITY.xml", description = "What is flown about in it.")
    private String entity;

    @Parameters(
            index = "2",
            arity = "0..1",
            paramLabel = "BACKGROUND",
            description = "A picture that fills the window behind it.")
    private String background;

    @Option(
            names = "--out",
            paramLabel = "F.png",
            description = "Take one picture offscreen instead of opening a window.")
    private Path out;

    @Option(names = "--size", paramLabel = "WxH", description = "Picture in pixels (default: the scene's window).")
    private Size size;

    @Option(
            names = "--time",
            paramLabel = "S",
            defaultValue = "0",
            description = "The scene's clock in seconds (default: 0).")
    @OptionRange.Decimal(least = -Environment.MOST_SECONDS, most = Environment.MOST_SECONDS, unit = "seconds")
    private double timeSeconds;

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

    static Preload preload() {
        return SystemDisplay.isPresent() ? Preload.nothing() : Preload.offscreenGraphics();
    }

    /** Wireframe is no word of {@code --shading}: it has an option of its own. */
    @Override
    public void register(CommandLine commandLine) {
        var filled = EnumSet.complementOf(EnumSet.of(Shading.WIREFRAME));
        commandLine
                .registerConverter(Shading.class, OptionValues.word(filled))
                .registerConverter(LightTerm.class, OptionValues.word(EnumSet.allOf(LightTerm.class)));
    }

    @Override
    public ExitCode run(Terminal terminal) throws IOException {
        checkUsage();
        var name = scene == null ? SceneName.SAMPLE : new SceneName(scene);
        var start = new SceneStart(opened(name, terminal), appearance(), timeSeconds);
        var pixels = pixels(start);
        if (out != null) {
            savePicture(start, pixels);
        } else if (SystemDisplay.isPresent()) {
            terminal.shown().run();
            Language language =
                    new PlayerFiles(UserFolders.ofThisUser()).settings().get(Settings.LANGUAGE);
            SceneViewer.show(start, name.title(), pixels, language);
        } else {
            new OffscreenTour(start, terminal.out()).save(PICTURES, name.stem(), pixels.width(), pixels.height());
        }
        return ExitCode.DONE;
    }

    private OpenedScene opened(SceneName name, Terminal terminal) {
        if (scene == null) {
            return OpenedScene.ofGame(name, terminal.err()::println);
        }
        return OpenedScene.of(name, entity == null ? null : new SceneName(entity), background, terminal.err()::println);
    }

    private Size pixels(SceneStart start) {
        var window = start.opened().scene().window();
        return size != null ? size : new Size(window.width(), window.height());
    }

    private void savePicture(SceneStart start, Size pixels) {
        try (var gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, pixels.width(), pixels.height());
                var drawing = FixedSceneDrawing.load(gl, start.opened().sources())) {
            var view = FixedSceneDrawing.view(start.opened().scene().eye(), (double) pixels.width() / pixels.height());
            drawing.draw(view, start.seconds(), start.worldFromEntity(), start.look(), target);
            gl.requireNoError("scene");
            WrittenFile.write(out, file -> Capture.png(target, file));
        }
    }

    private void checkUsage() {
        if (out != null && !out.toString().toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw CommandFailure.usage("--out must end in .png: " + out);
        }
    }

    private SceneAppearance appearance() {
        if (wireframe && shading != null) {
            throw CommandFailure.usage("--wireframe and --shading exclude each other");
        }
        var shown = SceneAppearance.USUAL
                .with(wireframe ? Shading.WIREFRAME : shading == null ? Shading.GOURAUD : shading)
                .withAxes(axes);
        return terms == null ? shown : shown.with(EnumSet.copyOf(terms));
    }
}
