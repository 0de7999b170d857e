package nephele.app.command;

import nephele.engine.draw.QualityChoice;
import nephele.engine.named.OpenedLevel;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.BakedSky;
import nephele.engine.terminal.PrintedProgress;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Which picture of a level is drawn offscreen: what measuring and saving have in common. */
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

    /** Complains about settings that do not exist. */
    void check() {
        quality.choice();
    }

    Size size() {
        return size;
    }

    double aspect() {
        return (double) size.width() / size.height();
    }

    /** What was asked for, or null. */
    Output output() {
        return output;
    }

    /** What was asked for, else what the level requires. */
    Output output(OpenedLevel opened) {
        return output != null ? output : choice().output(opened.level());
    }

    QualityChoice choice() {
        return quality.choice();
    }

    RenderTarget target(GlContext gl) {
        return RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, size.width(), size.height());
    }

    /** @param forced instead of what was asked for, or null */
    Renderer renderer(OpenedLevel opened, GlContext gl, Output forced, PrintedProgress progress) {
        var choice = choice();
        var settings = choice.settings(
                forced != null ? forced : output(opened), gl.limits().software());
        var shown = choice.shown(opened);
        return Renderer.load(gl, Scene.of(shown, BakedSky.of(shown, progress)), settings);
    }
}
