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

    private static final String SAMPLE_FOLDER = "levels/samples/";
    private static final double MOST_BIAS = 0.03;
    private static final double MOST_BIAS_OF_ROOMS = 0.015;
    private static final double MOST_FLIP = 0.06;

    /** By this a sample's HDR-FLIP may exceed that of its picture without a bake to the twin's of direct light. */
    private static final double MOST_FLIP_OF_BAKE = 0.005;

    /** Light that few paths find, as in the second of two rooms, makes pictures of the usual samples noisier than the bar. */
    private static final int ROOM_SAMPLES = 16;

    private static final int CAMERAS = 3;

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
     * @param samples rays a pixel of a level
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
                "Four reference rooms, the samples " + String.join(", ", SAMPLES)
                        + " and the levels of the campaign, drawn at quality high (" + width + " × " + height
                        + ", each pixel the mean of four) from"
                        + " up to " + CAMERAS + " cameras with freshly baked light, differ from all light traced with "
                        + samples + " samples a pixel (the rooms " + ROOM_SAMPLES * samples
                        + "), portals closed to it, by"
                        + " at most 3 % in the mean (the rooms 1.5 %), and in HDR-FLIP by at most 0.06 more than two"
                        + " traced pictures of different seeds; a sample by at most 0.005 more than without a bake from"
                        + " direct light.",
                "levels",
                cases().size(),
                1);
    }

    private static List<String> cases() {
        return Stream.of(
                        ReferenceCase.INTERIORS.stream(),
                        SAMPLES.stream().map(name -> SAMPLE_FOLDER + name + ".json"),
                        CAMPAIGN.stream().map(name -> "levels/" + name + ".json"))
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
        var twin = new Twin(
                placed, isRoom ? name : TracedPictures.levelHash(opened), isRoom ? ROOM_SAMPLES * samples : samples);
        double mostBias = isRoom ? MOST_BIAS_OF_ROOMS : MOST_BIAS;
        Scene scene = Scene.of(placed, baked(placed));
        boolean isSample = name.startsWith(SAMPLE_FOLDER);
        RenderSettings drawing = RenderSettings.of(Output.HDR, Quality.HIGH).with(Decoration.OFF);
        List<String> failures = new ArrayList<>();
        List<Figure> figures = new ArrayList<>();
        try (Renderer renderer = LevelRenderer.load(gl, scene, drawing);
                Renderer unbaked = isSample ? LevelRenderer.load(gl, unbaked(placed), drawing) : null) {
            List<View> views = views(placed.level(), name);
            for (int camera = 0; camera < views.size(); camera++) {
                View view = views.get(camera);
                Difference all = twin.difference(drawn(renderer, view, picture), view, LightTransport.BAKED);
                double mostFlip = MOST_FLIP;
                figures.add(Figure.sum(name + " camera " + camera + ", bias", 100 * all.bias(), "%"));
                figures.add(Figure.sum(
                        name + " camera " + camera + ", HDR-FLIP above that of two seeds", all.flipBeyondSeeds(), ""));
                if (isSample) {
                    Difference direct = twin.difference(drawn(unbaked, view, picture), view, LightTransport.DIRECT);
                    mostFlip = Math.min(mostFlip, Math.max(0, direct.flipBeyondSeeds()) + MOST_FLIP_OF_BAKE);
                    figures.add(Figure.sum(
                            name + " camera " + camera + ", the same without a bake, direct light alone",
                            direct.flipBeyondSeeds(),
                            ""));
                }
                if (!(Math.abs(all.bias()) <= mostBias) || !(all.flipBeyondSeeds() <= mostFlip)) {
                    failures.add(String.format(
                            Locale.ROOT,
                            "%s camera %d: bias %.2f %%, HDR-FLIP %.4f above that of two seeds, at most %.4f",
                            name,
                            camera,
                            100 * all.bias(),
                            all.flipBeyondSeeds(),
                            mostFlip));
                }
            }
            gl.requireNoError(name);
        }
        // A level fails once, however many of its pictures do.
        return new ProofResult(1, failures.isEmpty() ? 0 : 1, figures, failures);
    }

    /**
     * What sets a picture apart from a traced one.
     *
     * @param bias of the mean, as a share of it
     * @param flipBeyondSeeds HDR-FLIP less that of two traced pictures of different seeds
     */
    private record Difference(double bias, double flipBeyondSeeds) {}

    /** Traced pictures of a level, with so many rays a pixel. */
    private final class Twin {
        private final PlacedLevel placed;
        private final String state;
        private final int rays;

        Twin(PlacedLevel placed, String state, int rays) {
            this.placed = placed;
            this.state = state;
            this.rays = rays;
        }

        Difference difference(LinearPicture drawn, View view, LightTransport transport) {
            LinearPicture exact = traced(view, transport, 1);
            LinearPicture again = traced(view, transport, 2);
            double seeds = HdrFlip.of(exact, again).mean();
            return new Difference(
                    ImageError.meanBias(exact, drawn), HdrFlip.of(exact, drawn).mean() - seeds);
        }

        private LinearPicture traced(View view, LightTransport transport, long seed) {
            Pinhole eye = TracedPictures.pinhole(view);
            int threads = Runtime.getRuntime().availableProcessors();
            TraceSettings trace = new TraceSettings(width, height, rays, seed, threads, transport);
            return kept.picture(state, eye, trace, () -> {
                PlacedLevel metered = TracedExposure.fixed(placed, ColourDecoding.SRGB, eye, 0);
                return ReferencePicture.trace(TracedLevel.of(metered, ColourDecoding.SRGB), eye, trace, done -> {});
            });
        }
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
        BakedLight sky = LevelLight.unbaked(placed, done -> {});
        return LevelLight.of(placed, sky == null ? null : sky.visibility(), bake.light());
    }

    private static Scene unbaked(PlacedLevel placed) {
        return Scene.of(placed, LevelLight.unbaked(placed, done -> {}));
    }

    private static LinearPicture drawn(Renderer renderer, View view, RenderTarget picture) {
        for (int frame = 0; frame < FRAMES; frame++) {
            renderer.draw(view, picture);
        }
        return new LinearPicture(picture.width(), picture.height(), renderer.readRadiance()).reduced(LitTally.FINER);
    }
}
