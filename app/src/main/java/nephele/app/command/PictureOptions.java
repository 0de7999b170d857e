package nephele.app.command;

import nephele.engine.choice.LevelRenderer;
import java.util.Optional;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.BakedSky;
import nephele.host.draw.QualityChoice;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.PrintedProgress;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of an offscreen picture of a level, shared by measuring and saving. */
final class PictureOptions {
    @Option(
            names = "--size",
            paramLabel = "WxH",
            converter = Size.Converter.class,
            description = "Picture in pixels (default: 1280x720).")
    private Size size = Size.DEFAULT;

    @Option(
            names = "--output",
            paramLabel = "O",
            description = "direct, hdr or plain (default: as the level requires).")
    private Output output;

    @Mixin
    private QualityOptions quality;

    /** Checks the settings; throws a usage failure for unknown ones. */
    void check() {
        quality.choice();
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
        return quality.choice();
    }

    RenderTarget target(GlContext gl) {
        return RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, size.width(), size.height());
    }

    /** @param forced replaces the requested output, or null */
    Renderer renderer(OpenedLevel opened, GlContext gl, Output forced, PrintedProgress progress) {
        var choice = choice();
        var settings = choice.settings(
                forced != null ? forced : output(opened), gl.limits().software());
        var shown = choice.shown(opened);
        return LevelRenderer.load(gl, Scene.of(shown, BakedSky.of(shown, progress)), settings);
    }
}
