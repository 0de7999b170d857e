package nephele.workshop.prove.picture;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.bake.LightBake;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.LightTransport;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedExposure;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import nephele.lab.bake.TracedPictures;
import nephele.workshop.prove.cloud.ReferenceCase;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Compares levels as they are drawn with baked light with all their light, traced. */
public final class BakedLightProof implements Proof {
    private static final List<String> CAMPAIGN = List.of(
            "01-courtyard", "02-first-shot", "03-momentum", "04-cube", "05-above-the-clouds", "06-standing-stones");

    /** Samples whose sky does not change: every kind of lamp, material, sky and static shape. */
    private static final List<String> SAMPLES = List.of(
            "lamps",
            "material-emission",
            "material-normals",
            "material-textures",
            "models",
            "portals",
            "sky-gradient",
            "sky-visibility",
            "slanted-walls",
            "spot",
            "stairs-and-slopes",
            "terrain-source");

    private static final double MOST_BIAS = 0.03;
    private static final double MOST_BIAS_OF_ROOMS = 0.015;
    private static final double MOST_FLIP = 0.06;

    private static final int CAMERAS = 3;
    private static final LightTransport ALL_LIGHT = new LightTransport(LightTransport.FULL.bounces(), false);

    /** Frames after which techniques that reuse the last picture have settled. */
    private static final int FRAMES = 4;

    private final LightBake.Settings settings;
    private final int width;
    private final int height;
    private final int samples;
    private final TracedPictures kept;

    public BakedLightProof() {
        this(LightBake.Settings.USUAL, 240, 64, Path.of("build", "proofs", "oracle"));
    }

    /**
     * @param width of a picture of 16 by 9, in pixels
     * @param samples rays a pixel
     * @param folder for traced pictures
     */
    BakedLightProof(LightBake.Settings settings, int width, int samples, Path folder) {
        this.settings = settings;
        this.width = width;
        height = width * 9 / 16;
        this.samples = samples;
        kept = new TracedPictures(folder, "oracle " + ReferencePicture.VERSION);
    }

    @Override
    public Claim claim() {
        return new Claim(
                "baked-light",
                "Four reference rooms, the levels of the campaign and the samples " + String.join(", ", SAMPLES)
                        + ", drawn at quality high (" + width + " × " + height + ", each pixel the mean of four) from"
                        + " up to " + CAMERAS + " cameras with freshly baked light, differ from all light traced with "
                        + samples + " samples a pixel, portals closed to it, by at most 3 % in the mean (the rooms 1.5"
                        + " %), and in HDR-FLIP by at most 0.06 more than two traced pictures of different seeds.",
                "levels",
                cases().size(),
                1);
    }

    private static List<String> cases() {
        return Stream.of(
                        ReferenceCase.INTERIORS.stream(),
                        CAMPAIGN.stream().map(name -> "levels/" + name + ".json"),
                        SAMPLES.stream().map(name -> "levels/samples/" + name + ".json"))
                .flatMap(names -> names)
                .toList();
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(
                        gl, "picture", PixelFormat.RGBA8, LitTally.FINER * width, LitTally.FINER * height)) {
            return ProofResult.ofUnits(from, count, progress, unit -> compared(cases().get((int) unit), gl, picture));
        }
    }

    private ProofResult compared(String name, GlContext gl, RenderTarget picture) {
        boolean isRoom = ReferenceCase.INTERIORS.contains(name);
        OpenedLevel opened = isRoom ? null : new LevelName(name).open();
        PlacedLevel placed = isRoom ? ReferenceCase.named(name).placed() : opened.placed();
        String state = isRoom ? name : TracedPictures.levelHash(opened);
        double mostBias = isRoom ? MOST_BIAS_OF_ROOMS : MOST_BIAS;
        Scene scene = Scene.of(placed, baked(placed));
        RenderSettings drawing = RenderSettings.of(Output.HDR, Quality.HIGH).with(Decoration.OFF);
        List<String> failures = new ArrayList<>();
        List<Figure> figures = new ArrayList<>();
        try (Renderer renderer = LevelRenderer.load(gl, scene, drawing)) {
            List<View> views = views(placed.level(), name);
            for (int camera = 0; camera < views.size(); camera++) {
                LinearPicture exact = traced(placed, state, views.get(camera), 1);
                LinearPicture again = traced(placed, state, views.get(camera), 2);
                LinearPicture drawn = drawn(renderer, views.get(camera), picture);
                double bias = ImageError.meanBias(exact, drawn);
                double seeds = HdrFlip.of(exact, again).mean();
                double flip = HdrFlip.of(exact, drawn).mean() - seeds;
                if (!(Math.abs(bias) <= mostBias) || !(flip <= MOST_FLIP)) {
                    failures.add(String.format(
                            Locale.ROOT,
                            "%s camera %d: bias %.2f %%, HDR-FLIP %.4f above that of two seeds, %.4f",
                            name,
                            camera,
                            100 * bias,
                            flip,
                            seeds));
                }
                figures.add(Figure.sum(name + " camera " + camera + ", bias", 100 * bias, "%"));
                figures.add(Figure.sum(name + " camera " + camera + ", HDR-FLIP above that of two seeds", flip, ""));
            }
            gl.requireNoError(name);
        }
        // A level fails once, however many of its pictures do.
        return new ProofResult(1, failures.isEmpty() ? 0 : 1, figures, failures);
    }

    private static List<View> views(Level level, String name) {
        double aspect = 16.0 / 9;
        return level.cameras().isEmpty()
                ? List.of(Viewpoints.standard(level, name, aspect).apply(0))
                : IntStream.range(0, Math.min(CAMERAS, level.cameras().size()))
                        .mapToObj(i -> View.ofCamera(level.cameras().get(i), 0, aspect))
                        .toList();
    }

    private BakedLight baked(PlacedLevel placed) {
        LightBake bake = LightBake.of(placed, settings);
        bake.run(LightBake.Checkpoint.NONE, done -> {});
        BakedLight stored = LevelLight.of(placed, done -> {});
        return LevelLight.of(placed, stored == null ? null : stored.visibility(), bake.light());
    }

    private LinearPicture traced(PlacedLevel placed, String state, View view, long seed) {
        Pinhole eye = TracedPictures.pinhole(view);
        int threads = Runtime.getRuntime().availableProcessors();
        TraceSettings trace = new TraceSettings(width, height, samples, seed, threads, ALL_LIGHT);
        return kept.picture(state, eye, trace, () -> {
            PlacedLevel metered = TracedExposure.fixed(placed, ColourDecoding.SRGB, eye, 0);
            return ReferencePicture.trace(TracedLevel.of(metered, ColourDecoding.SRGB), eye, trace, done -> {});
        });
    }

    private static LinearPicture drawn(Renderer renderer, View view, RenderTarget picture) {
        for (int frame = 0; frame < FRAMES; frame++) {
            renderer.draw(view, picture);
        }
        return new LinearPicture(picture.width(), picture.height(), renderer.readRadiance()).reduced(LitTally.FINER);
    }
}
