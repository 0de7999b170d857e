package nephele.workshop.prove.picture;

import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.lab.bake.TracedPictures;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Compares the linear radiance of lit pictures, from the cameras of {@code portal-ids}, drawn by both portal techniques
 * and traced. The traced pictures are kept, because they take nearly all of the time.
 */
public final class PortalLightProof implements Proof {
    /** Successive cameras of a level: loading and warming up a level costs as much as tracing a few pictures. */
    private static final int AT_ONCE = 5;

    private static final Path KEPT = Path.of("build", "proofs", "oracle");

    private final ComparedCameras cameras;
    private final TracedPictures kept;
    private final TraceSettings trace;

    /** Uses the levels of the checkout in the working directory. */
    public PortalLightProof() {
        this(ComparedLevel.files(), 320, 64, KEPT);
    }

    /**
     * @param files levels by path
     * @param width of a picture of 16 by 9, in pixels
     * @param samples rays a pixel
     * @param folder for traced pictures
     */
    public PortalLightProof(List<String> files, int width, int samples, Path folder) {
        cameras = new ComparedCameras(files, AT_ONCE);
        kept = new TracedPictures(folder, "oracle " + ReferencePicture.VERSION);
        int threads = Runtime.getRuntime().availableProcessors();
        trace = new TraceSettings(width, width * 9 / 16, samples, 1, threads);
    }

    @Override
    public Claim claim() {
        return new Claim(
                "portal-light",
                "With direct light, each level's pictures (one sample a pixel, " + trace.width() + " × "
                        + trace.height()
                        + ", quality ultra without anisotropy) have a mean HDR-FLIP of at most 0.05 and a bias of at"
                        + " most 1 % against " + trace.samples()
                        + " traced samples a pixel, with either portal technique.",
                "cameras",
                cameras::all,
                AT_ONCE);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var tally = new LitTally();
        var visits = cameras.visits(from, count);
        long done = 0;
        try (var gl = GlContext.offscreen();
                var picture = picture(gl, 1);
                var finer = picture(gl, LitTally.FINER)) {
            for (var visit : visits) {
                compare(visit, gl, List.of(picture, finer), tally);
                done += visit.count();
                progress.unitsDone(done);
            }
        }
        return tally.result(count);
    }

    /** Judges each level by all its pictures together, regardless of their batches. */
    @Override
    public ProofResult judged(ProofResult soFar) {
        var series = ComparedLevel.TECHNIQUES.stream()
                .flatMap(technique -> cameras.files().stream().map(file -> series(technique, file)))
                .toList();
        return LitTally.judged(soFar, series);
    }

    private static String series(PortalTechnique technique, String file) {
        return technique + ", " + file;
    }

    private RenderTarget picture(GlContext gl, int factor) {
        return RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, factor * trace.width(), factor * trace.height());
    }

    private void compare(ComparedCameras.Visit visit, GlContext gl, List<RenderTarget> pictures, LitTally tally) {
        String file = visit.file();
        var opened = new LevelName(file).open();
        String state = TracedPictures.levelHash(opened);
        var compared = ComparedLevel.compared(opened.level());
        try (var level = new ComparedLevel<>(gl, compared, opened.assets(), ColourDecoding.SRGB, variants())) {
            for (int camera = visit.first(); camera < visit.first() + visit.count(); camera++) {
                View view = level.view(camera);
                Pinhole eye = TracedPictures.pinhole(view);
                LinearPicture reference = kept.picture(
                        state, eye, trace, () -> ReferencePicture.trace(level.traced(), eye, trace, done -> {}));
                Map<PortalTechnique, LinearPicture> finer = drawn(level, view, pictures.get(1));
                String again = ComparedCameras.again(file, camera, view);
                drawn(level, view, pictures.get(0))
                        .forEach((technique, once) -> tally.compare(
                                series(technique, file),
                                again,
                                reference,
                                once,
                                finer.get(technique).reduced(LitTally.FINER)));
            }
        }
    }

    private static Map<PortalTechnique, LinearPicture> drawn(
            ComparedLevel<PortalTechnique> level, View view, RenderTarget picture) {
        var drawn = new EnumMap<PortalTechnique, LinearPicture>(PortalTechnique.class);
        level.draw(view, picture, (technique, renderer) -> drawn.put(technique, radiance(renderer, picture)));
        return drawn;
    }

    private static LinearPicture radiance(Renderer renderer, RenderTarget picture) {
        return new LinearPicture(picture.width(), picture.height(), renderer.readRadiance());
    }

    private static Map<PortalTechnique, RenderSettings> variants() {
        var variants = new EnumMap<PortalTechnique, RenderSettings>(PortalTechnique.class);
        for (PortalTechnique technique : ComparedLevel.TECHNIQUES) {
            // llvmpipe 22.3 takes ten seconds for an anisotropic picture in which a footprint degenerates.
            Quality quality = Quality.ULTRA
                    .with("anisotropy", 1)
                    .with("portalTechnique", technique)
                    .with("viewBudget", ComparedLevel.UNLIMITED)
                    .with("portalResolution", 1);
            variants.put(technique, RenderSettings.of(Output.HDR, quality).with(Decoration.OFF));
        }
        return variants;
    }
}
