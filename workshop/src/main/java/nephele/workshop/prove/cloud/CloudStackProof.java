package nephele.workshop.prove.cloud;

import java.util.List;
import java.util.Locale;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Camera;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.lab.bake.TracedPictures;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Compares a sky in which all techniques of clouds lie on top of each other with traced pictures, from each of its cameras. */
public final class CloudStackProof implements Proof {
    private static final String LEVEL = "levels/samples/clouds-stacked.json";
    private static final int CAMERAS = 3;
    private static final double MOST_FLIP = 0.08;
    private static final int WIDTH = 48;
    private static final int HEIGHT = 27;
    /** Pixels along each side that are drawn for each one of the picture. */
    private static final int SIDE = 16;

    private static final int SAMPLES = 512;

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-stack",
                "Particles, billboards, two skyplanes, a volume and a skybox on top of each other, from below, between"
                        + " and above the skyplanes: HDR-FLIP to traced pictures (" + WIDTH + " × " + HEIGHT + ", "
                        + SAMPLES + " samples a pixel) is at most " + MOST_FLIP + ".",
                "pictures",
                CAMERAS,
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        OpenedLevel opened = new LevelName(LEVEL).open();
        TracedLevel traced = TracedLevel.of(opened.placed(), ColourDecoding.SRGB);
        try (GlContext gl = GlContext.offscreen()) {
            for (long unit = from; unit < from + count; unit++) {
                Camera camera = opened.level().cameras().get((int) unit);
                View view = View.ofCamera(camera, 0, (double) WIDTH / HEIGHT);
                var settings = new TraceSettings(
                        WIDTH, HEIGHT, SAMPLES, 1, Runtime.getRuntime().availableProcessors());
                float[] exact = ReferencePicture.trace(traced, TracedPictures.pinhole(view), settings, fraction -> {});
                double error = HdrFlip.of(new LinearPicture(WIDTH, HEIGHT, exact), drawn(gl, opened, view))
                        .mean();
                result = result.and(judged(camera.id(), error));
                progress.unitsDone(unit + 1 - from);
            }
        }
        return result;
    }

    private static LinearPicture drawn(GlContext gl, OpenedLevel opened, View view) {
        var settings = RenderSettings.of(Output.HDR, Quality.ULTRA.with("samples", 1));
        try (var target = RenderTarget.picture(gl, "stack", PixelFormat.RGBA8, SIDE * WIDTH, SIDE * HEIGHT);
                Renderer renderer = LevelRenderer.load(gl, opened.level(), opened.assets(), settings)) {
            renderer.draw(view, target);
            gl.requireNoError("stack");
            return new LinearPicture(target.width(), target.height(), renderer.readRadiance()).reduced(SIDE);
        }
    }

    private static ProofResult judged(String camera, double error) {
        List<String> failures = error <= MOST_FLIP
                ? List.of()
                : List.of(String.format(Locale.ROOT, "%s: HDR-FLIP %.4f", camera, error));
        return ProofResult.of(1, failures, Figure.greatest("HDR-FLIP from " + camera, error, ""));
    }
}
