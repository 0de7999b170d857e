package nephele.app.command;

import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.named.AssetProblems;
import nephele.engine.named.OpenedLevel;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import nephele.engine.terminal.CommandFailure;
import nephele.engine.terminal.PrintedProgress;
import nephele.engine.terminal.Terminal;
import nephele.lab.oracle.PinholeViews;
import picocli.CommandLine.Option;

/** The options of the reference path tracer, which traces rays on all cores instead of drawing with OpenGL. */
final class ReferenceOptions {
    private static final int USUAL_SAMPLES = 64;
    private static final int MOST_SAMPLES = 1 << 20;

    @Option(names = "--reference", description = "Trace exact rays on the CPU instead of drawing.")
    private boolean reference;

    @Option(names = "--spp", paramLabel = "N", description = "Samples a pixel of --reference (default: 64).")
    private Integer samples;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of --reference (default: 1).")
    private Long seed;

    void check() {
        if (!reference && (samples != null || seed != null)) {
            throw CommandFailure.usage("--spp and --seed belong to --reference");
        }
        if (samples != null && (samples < 1 || samples > MOST_SAMPLES)) {
            throw CommandFailure.usage("--spp is a whole number from 1 to " + MOST_SAMPLES + ", not " + samples);
        }
    }

    private static PlacedLevel at(PlacedLevel placed, double seconds) {
        return new PlacedLevel(Daylight.lit(placed.level(), seconds), placed.assets(), placed.statics());
    }

    boolean isAsked() {
        return reference;
    }

    /**
     * Returns linear radiance, the bottom row first. A picture of ids has one sample, in the centre of each pixel, as
     * ids must not be averaged.
     *
     * @param seconds the environment's clock
     */
    float[] trace(OpenedLevel opened, double seconds, View view, PictureOptions picture, Terminal terminal) {
        var shown = at(picture.choice().shown(opened), seconds);
        var decoding = picture.output(opened) == Output.PLAIN ? ColourDecoding.AS_STORED : ColourDecoding.SRGB;
        var level = AssetProblems.named(opened, () -> TracedLevel.of(shown, decoding));
        int usual = samples == null ? USUAL_SAMPLES : samples;
        var settings = new TraceSettings(
                picture.size().width(),
                picture.size().height(),
                picture.choice().showsIds() ? 1 : usual,
                seed == null ? 1 : seed,
                Runtime.getRuntime().availableProcessors());
        return ReferencePicture.trace(level, PinholeViews.of(view), settings, PrintedProgress.ofTrace(terminal.err()));
    }
}
