package nephele.app.command;

import java.io.PrintStream;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import nephele.app.window.Size;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.QualityField;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.host.draw.QualityChoice;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.PrintedProgress;
import picocli.CommandLine.Option;

/** The options of an offscreen picture of a level, shared by measuring and saving. */
final class PictureOptions {
    @Option(names = "--size", paramLabel = "WxH", description = "Picture in pixels (default: 1280x720).")
    private Size size = Size.DEFAULT;

    @Option(
            names = "--output",
            paramLabel = "O",
            description = "direct, hdr or plain (default: as the level requires).")
    private Output output;

    @Option(
            names = "--quality",
            paramLabel = "Q",
            defaultValue = "high",
            description =
                    "low, medium, high, ultra or auto, as play draws them: low with half the resolution, scaled up;"
                            + " auto as play begins (default: high).")
    private String quality;

    @Option(
            names = "--set",
            paramLabel = "KEY=VALUE",
            parameterConsumer = SettingConsumer.class,
            description =
                    "Change single settings: ${COMPLETION-CANDIDATES}; debug=ids draws every solid in its own colour.",
            completionCandidates = SettingNames.class)
    private Map<String, String> settings = new LinkedHashMap<>();

    /** Checks the settings; throws a usage failure for unknown ones. */
    void check() {
        choice();
    }

    Size size() {
        return size;
    }

    double aspect() {
        return (double) size.width() / size.height();
    }

    /** Returns the requested output, or null. */
    Output output() {
        return output;
    }

    /** Returns the requested output, else the one that the level requires. */
    Output output(OpenedLevel opened) {
        return output != null ? output : choice().output(opened.level());
    }

    /** Returns a notice if the requested output cannot show the level's exposure. */
    Optional<String> unmetered(OpenedLevel opened) {
        return output == Output.DIRECT
                        && opened.level().environment().exposureStops().isAuto()
                ? Optional.of("output direct has no linear picture to meter: exposureStops \"auto\" counts as 0")
                : Optional.empty();
    }

    QualityChoice choice() {
        return at(quality);
    }

    /** Returns the choice of another preset, with the same single settings. */
    QualityChoice at(String preset) {
        var choice = new QualityChoice(preset, settings);
        choice.check();
        return choice;
    }

    RenderTarget target(GlContext gl) {
        return RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, size.width(), size.height());
    }

    /**
     * @param forced replaces the requested output, or null
     * @param err receives the progress of a bake, and a warning about baked light that is ignored
     */
    Renderer renderer(OpenedLevel opened, GlContext gl, Output forced, PrintStream err) {
        return renderer(opened, gl, choice(), forced, err);
    }

    /** Builds the renderer for another choice than the requested one. */
    Renderer renderer(OpenedLevel opened, GlContext gl, QualityChoice choice, Output forced, PrintStream err) {
        var settings = choice.settings(
                forced != null ? forced : output(opened), gl.limits().software());
        if (forced != null) {
            // The radiance that is read is that of the last frame alone.
            settings = settings.with(settings.quality().inOneFrame());
        }
        var shown = choice.drawn(opened);
        var light = choice.light(shown, opened.file(), PrintedProgress.ofBake(err), err::println);
        return LevelRenderer.load(gl, Scene.of(shown, light), settings);
    }

    /** The names of all settings, for the help. */
    static final class SettingNames implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return QualityChoice.FIELDS.stream().map(QualityField::name).iterator();
        }
    }
}
