package nephele.app.prove;

import java.util.List;
import nephele.app.draw.IdLevel;
import nephele.app.levels.LevelName;
import nephele.engine.level.Level;
import nephele.engine.level.LevelFile;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.Capture;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;

/** Identity colours of every level and sample from seeded cameras, drawn by both portal techniques against traced. */
public final class PortalIdsProof implements Proof {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;

    /** As many as `--set viewBudget` takes. */
    static final int UNLIMITED = 9999;

    /** The others of {@link PortalTechnique} are variants of the second, of which the trade report tells. */
    static final List<PortalTechnique> TECHNIQUES = List.of(PortalTechnique.STENCIL, PortalTechnique.TEXTURE);

    private final List<String> files;

    /** Of the checkout in the working directory. */
    public PortalIdsProof() {
        this(levels());
    }

    /** @param files levels by path */
    public PortalIdsProof(List<String> files) {
        this.files = files;
    }

    /** All levels and samples of the checkout in the working directory. */
    public static List<String> levels() {
        return SeenLevels.all();
    }

    @Override
    public String name() {
        return "portal-ids";
    }

    @Override
    public String claim() {
        return "By either technique, no pixel shows another surface than the exact twin, except within one pixel of an"
                + " edge.";
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
            throw new UnavailableException("portal-ids compares the levels of a checkout: run it in one");
        }
        var tally = new IdTally();
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, WIDTH, HEIGHT)) {
            for (long unit = from; unit < from + count; ) {
                var first = ComparedLevel.of(files, unit);
                int cameras = (int) Math.min(from + count - unit, ComparedLevel.CAMERAS - first.camera());
                var subject = new Subject(first.file(), gl, picture);
                for (PortalTechnique technique : TECHNIQUES) {
                    for (int budget : new int[] {UNLIMITED, Quality.HIGH.viewBudget()}) {
                        subject.compare(technique, budget, first.camera(), cameras, tally);
                    }
                }
                unit += cameras;
                progress.unitsDone(unit - from);
            }
        }
        return tally.result(count);
    }

    /** One level. */
    private static final class Subject {
        private final String file;
        private final GlContext gl;
        private final RenderTarget picture;
        private final Scene scene;
        private final TracedLevel traced;
        private final SeededCameras cameras;
        private final SightPicture[] sights = new SightPicture[ComparedLevel.CAMERAS];

        Subject(String file, GlContext gl, RenderTarget picture) {
            this.file = file;
            this.gl = gl;
            this.picture = picture;
            LevelFile.Opened opened = new LevelName(file).open();
            Level ids = IdLevel.of(opened.level());
            scene = Scene.of(ids, opened.assets());
            traced = TracedLevel.of(ids, opened.assets(), Decoding.AS_STORED);
            cameras = new SeededCameras(ids, traced, (double) WIDTH / HEIGHT);
        }

        void compare(PortalTechnique technique, int budget, int first, int count, IdTally tally) {
            Quality quality = Quality.HIGH
                    .withSamples(1)
                    .withPortalTechnique(technique)
                    .withViewBudget(budget)
                    .withPortalResolution(1);
            RenderSettings settings = RenderSettings.of(Output.PLAIN, quality)
                    .with(Decoration.OFF)
                    .with(Deepest.MARK);
            try (var renderer = Renderer.load(gl, scene, settings)) {
                for (int camera = first; camera < first + count; camera++) {
                    View view = cameras.view(camera);
                    if (sights[camera] == null) {
                        sights[camera] = new SightPicture(traced, view, WIDTH, HEIGHT);
                    }
                    renderer.draw(view, picture);
                    gl.requireNoError(file);
                    String what = technique + ", budget " + budget + ", " + ComparedLevel.again(file, camera, view);
                    var views = budget == UNLIMITED ? IdTally.Views.ALL : IdTally.Views.BUDGETED;
                    tally.compare(Capture.image(picture), sights[camera], views, what);
                }
            }
        }
    }
}
