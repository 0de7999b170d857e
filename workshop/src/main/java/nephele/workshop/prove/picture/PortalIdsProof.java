package nephele.workshop.prove.picture;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.render.Capture;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import nephele.host.named.LevelName;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Compares identity colours of every level and sample, from seeded cameras, drawn by both portal techniques and traced.
 */
public final class PortalIdsProof implements Proof {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;
    private static final Map<Variant, RenderSettings> VARIANTS = variants();

    private final ComparedCameras cameras;

    /** What differs between the drawn pictures of a camera. */
    private record Variant(PortalTechnique technique, int budget) {}

    /** Uses the levels of the checkout in the working directory. */
    public PortalIdsProof() {
        this(ComparedLevel.files());
    }

    /** @param files levels by path */
    public PortalIdsProof(List<String> files) {
        // Five successive cameras cover every kind of view.
        cameras = new ComparedCameras(files, 5);
    }

    @Override
    public Claim claim() {
        return new Claim(
                "portal-ids",
                "With either portal technique, no pixel shows another surface than the exact twin, except"
                        + " within one pixel of the edge of a surface or an opening.",
                "cameras",
                cameras::all,
                (long) cameras.atOnce() * cameras.files().size());
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var tally = new IdTally();
        var visits = cameras.visits(from, count);
        long done = 0;
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, WIDTH, HEIGHT)) {
            for (var visit : visits) {
                compare(visit, gl, picture, tally);
                done += visit.count();
                progress.unitsDone(done);
            }
        }
        return tally.result(count);
    }

    private static void compare(ComparedCameras.Visit visit, GlContext gl, RenderTarget picture, IdTally tally) {
        var opened = new LevelName(visit.file()).open();
        var ids = IdLevel.of(ComparedLevel.compared(opened.level()));
        try (var level = new ComparedLevel<>(gl, ids, opened.assets(), ColourDecoding.AS_STORED, VARIANTS)) {
            for (int camera = visit.first(); camera < visit.first() + visit.count(); camera++) {
                View view = level.view(camera);
                var sight = new SightPicture(level.traced(), view, WIDTH, HEIGHT);
                String again = ComparedCameras.again(visit.file(), camera, view);
                level.draw(view, picture, (variant, renderer) -> {
                    String what = variant.technique() + ", budget " + variant.budget() + ", " + again;
                    tally.compare(Capture.image(picture), sight, variant.budget(), what);
                });
            }
        }
    }

    private static Map<Variant, RenderSettings> variants() {
        var variants = new LinkedHashMap<Variant, RenderSettings>();
        for (PortalTechnique technique : ComparedLevel.TECHNIQUES) {
            for (int budget : new int[] {ComparedLevel.UNLIMITED, Quality.HIGH.viewBudget()}) {
                Quality quality = Quality.HIGH
                        .with("samples", 1)
                        .with("portalTechnique", technique)
                        .with("viewBudget", budget)
                        .with("portalResolution", 1);
                RenderSettings settings = RenderSettings.of(Output.PLAIN, quality)
                        .with(Decoration.OFF)
                        .with(Deepest.MARK);
                variants.put(new Variant(technique, budget), settings);
            }
        }
        return variants;
    }
}
