package nephele.app.prove;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import nephele.app.draw.ReferenceEye;
import nephele.app.levels.LevelName;
import nephele.engine.level.LevelFile;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;

/** The cameras of {@code portal-ids} again, lit: linear radiance by both portal techniques against traced. */
public final class PortalLightProof implements Proof {
    /** Pixels drawn for each compared one along each side: a texture's filter and an edge's samples are then near exact. */
    private static final int FINER = 2;

    private final List<String> files;
    private final int width;
    private final int samples;

    /** Of the checkout in the working directory. */
    public PortalLightProof() {
        this(SeenLevels.all(), 320, 64);
    }

    /**
     * @param files levels by path
     * @param width of a picture of 16 by 9
     * @param samples rays a pixel
     */
    public PortalLightProof(List<String> files, int width, int samples) {
        this.files = files;
        this.width = width;
        this.samples = samples;
    }

    @Override
    public String name() {
        return "portal-light";
    }

    @Override
    public String claim() {
        return "Lit, each level's pictures, drawn at quality ultra without anisotropy at twice the size and averaged,"
            + " have a mean HDR-FLIP of at most 0.05 and a bias of at most 1 % against 64 traced samples a pixel, by"
            + " either portal technique.";
    }

    @Override
    public String unit() {
        return "cameras";
    }

    @Override
    public long fullCount() {
        return (long) ComparedLevel.CAMERAS * files.size();
    }

    @Override
    public long batch() {
        return ComparedLevel.CAMERAS;
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws UnavailableException {
        if (files.isEmpty()) {
            throw new UnavailableException("portal-light compares the levels of a checkout: run it in one");
        }
        var tally = new LitTally();
        try (var gl = GlContext.offscreen();
                var picture = picture(gl, 1);
                var finer = picture(gl, FINER)) {
            for (long unit = from; unit < from + count; ) {
                var first = ComparedLevel.of(files, unit);
                int cameras = (int) Math.min(from + count - unit, ComparedLevel.CAMERAS - first.camera());
                long done = unit - from;
                compare(
                        first,
                        cameras,
                        gl,
                        List.of(picture, finer),
                        tally,
                        camera -> progress.unitsDone(done + camera));
                unit += cameras;
            }
        }
        return tally.result(count);
    }

    private RenderTarget picture(GlContext gl, int factor) {
        return RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, factor * width, factor * (width * 9 / 16));
    }

    private void compare(
            ComparedLevel first,
            int cameras,
            GlContext gl,
            List<RenderTarget> pictures,
            LitTally tally,
            Progress progress) {
        String file = first.file();
        LevelFile.Opened opened = new LevelName(file).open();
        TracedLevel traced = TracedLevel.of(opened.level(), opened.assets(), Decoding.SRGB);
        Scene scene = Scene.of(opened.level(), opened.assets());
        var seeded = new SeededCameras(opened.level(), traced, 16.0 / 9);
        Map<PortalTechnique, LitTally.OfLevel> tallies = new EnumMap<>(PortalTechnique.class);
        Map<PortalTechnique, Renderer> renderers = new EnumMap<>(PortalTechnique.class);
        try {
            for (PortalTechnique technique : PortalIdsProof.TECHNIQUES) {
                tallies.put(technique, tally.level(technique + ", " + file));
                renderers.put(technique, Renderer.load(gl, scene, settings(technique)));
            }
            for (int i = 0; i < cameras; i++) {
                int camera = first.camera() + i;
                View view = seeded.view(camera);
                LinearPicture reference = traced(traced, view);
                renderers.forEach((technique, renderer) -> {
                    LinearPicture once = drawn(renderer, view, pictures.get(0));
                    LinearPicture finer = drawn(renderer, view, pictures.get(1)).reduced(FINER);
                    gl.requireNoError(file);
                    tallies.get(technique).compare(reference, finer, ComparedLevel.again(file, camera, view));
                    tallies.get(technique).once(reference, once);
                });
                progress.unitsDone(i + 1);
            }
        } finally {
            renderers.values().forEach(Renderer::close);
        }
        tallies.values().forEach(LitTally.OfLevel::end);
    }

    private static LinearPicture drawn(Renderer renderer, View view, RenderTarget picture) {
        renderer.draw(view, picture);
        return new LinearPicture(picture.width(), picture.height(), renderer.readRadiance());
    }

    private static RenderSettings settings(PortalTechnique technique) {
        // llvmpipe 22.3 takes ten seconds for an anisotropic picture in which a footprint degenerates.
        Quality quality = Quality.ULTRA
                .withAnisotropy(1)
                .withPortalTechnique(technique)
                .withViewBudget(PortalIdsProof.UNLIMITED)
                .withPortalResolution(1);
        return RenderSettings.of(Output.HDR, quality).with(Decoration.OFF);
    }

    private LinearPicture traced(TracedLevel level, View view) {
        int height = width * 9 / 16;
        var settings = new TraceSettings(
                width, height, samples, 1, Runtime.getRuntime().availableProcessors());
        return new LinearPicture(
                width, height, ReferencePicture.trace(level, ReferenceEye.of(view), settings, done -> {}));
    }
}
