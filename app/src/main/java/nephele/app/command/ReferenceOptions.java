package nephele.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.reference.LightTransport;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedExposure;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.tile.MergedParts;
import nephele.engine.reference.tile.PartHeader;
import nephele.engine.reference.tile.PixelMean;
import nephele.engine.reference.tile.Shard;
import nephele.engine.reference.tile.TiledPicture;
import nephele.engine.render.Capture;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.Terminal;
import nephele.lab.bake.ResumableTrace;
import nephele.lab.bake.TracedPictures;
import picocli.CommandLine.Option;

/** The options of the reference path tracer, which traces rays on all cores instead of drawing with OpenGL. */
public final class ReferenceOptions {
    private static final int USUAL_SAMPLES = 64;
    private static final int MOST_SAMPLES = 1 << 20;

    @Option(
            names = "--reference",
            description = "Trace exact rays on the CPU instead of drawing. An interrupted run goes on when the same"
                    + " command is typed again.")
    private boolean reference;

    @Option(names = "--spp", paramLabel = "N", description = "Samples a pixel of --reference (default: 64).")
    @OptionRange.Whole(least = 1, most = MOST_SAMPLES)
    private Integer samples;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of --reference (default: 1).")
    @OptionRange.Whole(least = Long.MIN_VALUE, most = Long.MAX_VALUE)
    private Long seed;

    @Option(
            names = "--bounces",
            paramLabel = "N",
            description = "The most surfaces that light of --reference meets before the one that is seen; 0 for direct"
                    + " light (default: as many as there are).")
    @OptionRange.Whole(least = 0, most = Integer.MAX_VALUE)
    private Integer bounces;

    @Option(
            names = "--portal-light",
            paramLabel = "on|off",
            description = "Whether light of --reference passes open portals, as eyes do (default: on).")
    private Switch portalLight;

    @Option(
            names = "--error",
            paramLabel = "E.pfm",
            description = "Also write the standard error of each value of --reference, from 32 batches of samples.")
    private Path error;

    @Option(
            names = "--shard",
            paramLabel = "i/n",
            description = "Trace every n-th tile of --reference only, from the i-th on, into FILE.i-of-n.part: for n"
                    + " machines.")
    private Shard shard;

    @Option(
            names = "--merge",
            paramLabel = "PART",
            arity = "1..*",
            description = "Write the picture that the parts of all shards make; needs no LEVEL.")
    private List<Path> parts;

    void check(Path out) {
        if (!reference
                && (samples != null || seed != null || shard != null || bounces != null || portalLight != null)) {
            throw CommandFailure.usage("--spp, --seed, --shard, --bounces and --portal-light belong to --reference");
        }
        if (isMerge() && reference) {
            throw CommandFailure.usage("--merge puts together what is traced; leave --reference out");
        }
        if ((isMerge() || shard != null) && !isPfm(out)) {
            throw CommandFailure.usage("--shard and --merge need an --out that ends in .pfm, not " + out);
        }
        checkError(out);
    }

    private void checkError(Path out) {
        if (error == null) {
            return;
        }
        if (!reference && !isMerge()) {
            throw CommandFailure.usage("--error belongs to --reference or --merge");
        }
        if (shard != null) {
            throw CommandFailure.usage("--error is written with the merged picture; leave it out with --shard");
        }
        if (!isPfm(error) || error.equals(out)) {
            throw CommandFailure.usage("--error must end in .pfm and differ from --out: " + error);
        }
        if (reference && samples() < PixelMean.BATCHES) {
            throw CommandFailure.usage("--error needs --spp of at least " + PixelMean.BATCHES + ", not " + samples());
        }
    }

    private static boolean isPfm(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(".pfm");
    }

    private int samples() {
        return samples == null ? USUAL_SAMPLES : samples;
    }

    private static PlacedLevel at(PlacedLevel placed, double seconds) {
        return new PlacedLevel(Daylight.lit(placed.level(), seconds), placed.assets(), placed.statics());
    }

    boolean isAsked() {
        return reference;
    }

    /** Returns what is seen with the exposure of this view at its time, if the level's radiance depends on it. */
    ViewedLevel exposed(ViewedLevel viewed, PictureOptions picture) {
        OpenedLevel opened = viewed.opened;
        if (picture.output(opened) == Output.PLAIN || !TracedExposure.isNeeded(opened.level())) {
            return viewed;
        }
        var eye = TracedPictures.pinhole(viewed.view);
        PlacedLevel metered =
                opened.reporting(() -> TracedExposure.fixed(opened.placed(), ColourDecoding.SRGB, eye, viewed.seconds));
        return new ViewedLevel(opened.edited(metered), viewed.view, viewed.seconds);
    }

    boolean isMerge() {
        return parts != null;
    }

    /** Writes what the parts make. */
    void merge(Path out) {
        TiledPicture picture = WrittenFile.ofParts(() -> MergedParts.of(parts));
        WrittenFile.write(out, file -> writePfm(picture, picture.rgb(), file));
        writeError(picture);
    }

    /** Writes the standard error of a picture if it is asked for. */
    private void writeError(TiledPicture picture) {
        if (error == null) {
            return;
        }
        if (!picture.hasError()) {
            throw CommandFailure.input("--error: the parts have too few samples a pixel; trace them with --spp "
                    + PixelMean.BATCHES + " or more");
        }
        WrittenFile.write(error, file -> writePfm(picture, picture.standardError(), file));
    }

    private static void writePfm(TiledPicture picture, float[] rgb, Path file) throws IOException {
        Capture.pfm(rgb, picture.tiles().width(), picture.tiles().height(), file);
    }

    /** A level, the view of it and the time of a picture. */
    record ViewedLevel(OpenedLevel opened, View view, double seconds) {}

    /**
     * Traces a picture or a shard of it and saves it. A picture of ids has one sample, in the centre of each pixel, as ids
     * must not be averaged.
     *
     * @param save writes linear radiance, the bottom row first
     */
    void trace(ViewedLevel viewed, PictureOptions picture, Path out, Consumer<float[]> save, Terminal terminal) {
        boolean isPlain = picture.output(viewed.opened) == Output.PLAIN;
        var decoding = isPlain ? ColourDecoding.AS_STORED : ColourDecoding.SRGB;
        var settings = new TraceSettings(
                picture.size().width(),
                picture.size().height(),
                picture.choice().showsIds() ? 1 : samples(),
                seed == null ? 1 : seed,
                Runtime.getRuntime().availableProcessors(),
                transport(picture));
        var shown = at(picture.choice().drawn(viewed.opened), viewed.seconds);
        var level = viewed.opened.reporting(() -> TracedLevel.of(shown, decoding, viewed.seconds));
        var eye = TracedPictures.pinhole(viewed.view);
        var facts = TracedPictures.facts(
                viewed.opened, viewed.seconds, eye, settings, picture.choice().showsIds() ? "ids" : decoding.name());
        var part = new ResumableTrace.Part(
                partFile(out),
                new PartHeader(settings.tiles(), Optional.ofNullable(shard).orElse(Shard.WHOLE), facts),
                eye);
        var trace = new ResumableTrace(List.of(part), terminal.err());
        TiledPicture traced =
                WrittenFile.ofParts(() -> trace.run(level, settings)).get(0);
        if (shard == null) {
            save.accept(traced.rgb());
            writeError(traced);
            WrittenFile.write(part.file(), file -> part.forget());
        }
    }

    private LightTransport transport(PictureOptions picture) {
        if (picture.choice().showsIds()) {
            return LightTransport.DIRECT;
        }
        int most = bounces == null ? LightTransport.FULL.bounces() : bounces;
        return new LightTransport(most, portalLight != Switch.OFF);
    }

    /** Values of an option, in lower case on the command line. */
    enum Switch {
        ON,
        OFF
    }

    private Path partFile(Path out) {
        String fraction = shard == null ? "" : "." + shard.number() + "-of-" + shard.of();
        return out.resolveSibling(out.getFileName() + fraction + ".part");
    }
}
