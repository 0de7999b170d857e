package nephele.engine.render.pass.impostor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Impostors against the meshes that they stand for. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class PlantGlTest {
    private static final int SIZE = 96;
    private static final double BEGIN = 32;
    /** The tangent of half the angle of the views. */
    private static final double TAN = 0.15;

    private static final String SHAPE = "torus_1_0.45_24_12.3d";
    private static final double DIAMETER = 2 * 1.45;
    private static final Quality MESHES = Quality.HIGH.inOneFrame().with("impostorPixels", 0);
    private static final Quality IMPOSTORS = Quality.HIGH.inOneFrame().with("impostorPixels", BEGIN);

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);
    private final TestAssets assets = new TestAssets();

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static TestLevel lit() {
        return new TestLevel()
                .sky(new Sky.Gradient(new Vec3(0.2, 0.4, 0.9), new Vec3(0.6, 0.6, 0.6), new Vec3(0.2, 0.15, 0.1)))
                .sun(new Vec3(0.5, 0.8, 0.4), 2);
    }

    private static Level one() {
        return lit().material("m", new Vec3(0.3, 0.6, 0.2)).impostor(SHAPE, "m").level();
    }

    /** Returns a view from far away in which the model has this many pixels. */
    private View view(double pixels, double azimuth, double elevation) {
        double metres = DIAMETER * SIZE / (2 * TAN) / pixels;
        Vec3 eye = new Vec3(
                metres * Math.cos(elevation) * Math.sin(azimuth),
                metres * Math.sin(elevation),
                metres * Math.cos(elevation) * Math.cos(azimuth));
        return towards(eye, Vec3.ZERO);
    }

    private static View towards(Vec3 eye, Vec3 target) {
        Projection narrow = new Projection(2 * Math.atan(TAN), 1, 0.05, 1000);
        return View.lookAt(eye, target, new Vec3(0, 1, 0), narrow);
    }

    private Renderer renderer(Level level, Quality quality) {
        return LevelRenderer.load(
                offscreen.gl, level, assets, RenderSettings.of(Output.HDR).with(quality));
    }

    private LinearPicture picture(Renderer renderer, View view) {
        renderer.forget();
        renderer.draw(view, offscreen.picture);
        offscreen.gl.requireNoError("plants");
        return new LinearPicture(SIZE, SIZE, renderer.readRadiance());
    }

    /** Draws with several samples a pixel, from eyes turned by parts of a pixel. */
    private LinearPicture sampled(Renderer renderer, View view) {
        float[] sum = new float[3 * SIZE * SIZE];
        int side = 4;
        for (int i = 0; i < side * side; i++) {
            double x = ((i % side + 0.5) / side - 0.5) * 2 * TAN / SIZE;
            double y = ((i / side + 0.5) / side - 0.5) * 2 * TAN / SIZE;
            Vec3 ahead = view.back().negated().addScaled(x, view.right()).addScaled(y, view.up());
            float[] one = picture(renderer, towards(view.eye(), view.eye().plus(ahead)))
                    .rgb();
            for (int k = 0; k < sum.length; k++) {
                sum[k] += one[k] / (side * side);
            }
        }
        return new LinearPicture(SIZE, SIZE, sum);
    }

    /** Only the pixels that the model may cover count: the background is always right. */
    private static double error(LinearPicture exact, LinearPicture test, double pixels) {
        return HdrFlip.of(exact, test).mean() * SIZE * SIZE / (pixels * pixels);
    }

    @Test
    void anImpostorLooksLikeItsMeshWhereItBegins() {
        double worst = 0;
        try (Renderer meshes = renderer(one(), MESHES);
                Renderer impostors = renderer(one(), IMPOSTORS)) {
            for (int i = 0; i < 6; i++) {
                View view = view(0.98 * BEGIN, 1.1 * i, 0.25 * i);
                worst = Math.max(worst, error(sampled(meshes, view), sampled(impostors, view), BEGIN));
            }
        }
        assertTrue(worst < 0.15, "HDR-FLIP " + worst);
        assertTrue(worst > 1e-4, "no impostor was drawn");
    }

    /** On an approach no frame differs more from the one before than meshes do. */
    @Test
    void meshesComeWithoutAPop() {
        try (Renderer meshes = renderer(one(), MESHES);
                Renderer impostors = renderer(one(), IMPOSTORS)) {
            LinearPicture meshBefore = null;
            LinearPicture before = null;
            for (double pixels = 0.85 * BEGIN; pixels < 1.4 * BEGIN; pixels *= 1.01) {
                View view = view(pixels, 0.4, 0.2);
                LinearPicture mesh = picture(meshes, view);
                LinearPicture now = picture(impostors, view);
                if (before != null) {
                    double step = HdrFlip.of(before, now).mean();
                    double own = HdrFlip.of(meshBefore, mesh).mean();
                    assertTrue(step < own + 0.02, pixels + " pixels: " + step + " instead of " + own);
                }
                meshBefore = mesh;
                before = now;
            }
            assertEquals(0, HdrFlip.of(meshBefore, before).mean(), 1e-6, "near, only the mesh is drawn");
        }
    }

    private int[] ids(Level level, View view, Quality quality) {
        return offscreen.pixels(
                IdLevel.of(level), assets, view, RenderSettings.of(Output.PLAIN).with(quality));
    }

    /** Returns the number of pixels in which two pictures differ. */
    private static int differing(int[] a, int[] b) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            count += a[i] == b[i] ? 0 : 1;
        }
        return count;
    }

    /** A portal's view chooses by the distance of its own eye, through the portal. */
    @Test
    void aViewThroughAPortalChoosesForItself() {
        Level level = lit().impostor(SHAPE, null, new Translate(new Vec3(100, 0, -1.2 * DIAMETER)))
                .portal("a", "b", new Vec3(0, 0, -1), new Vec3(0, 0, 1), 3, 3)
                .portal("b", "a", new Vec3(100, 0, 0), new Vec3(0, 0, -1), 3, 3)
                .level();
        View near = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
        int[] mesh = ids(level, near, MESHES);
        int seen = (int) Arrays.stream(mesh)
                .filter(pixel -> pixel == mesh[SIZE * SIZE / 2 + SIZE / 2 + 8])
                .count();
        assertTrue(seen > 50 && seen < SIZE * SIZE / 2, seen + " pixels show it");
        assertEquals(
                0, differing(mesh, ids(level, near, IMPOSTORS.with("impostorPixels", 20))), "large through the portal");
        int others = differing(mesh, ids(level, near, IMPOSTORS.with("impostorPixels", 64)));
        assertTrue(others > 0 && others < seen / 3, others + " of " + seen + " pixels differ");
    }

    @Test
    void aMillionMetresAwayThePictureIsTheSame() {
        Vec3 far = new Vec3(1 << 20, 0, -(1 << 20));
        Level moved = lit().box(null, far.minus(new Vec3(0, 5, 0)), new Vec3(0.01, 0.01, 0.01))
                .impostor(SHAPE, null, new Translate(far))
                .level();
        Level level = lit().box(null, new Vec3(0, -5, 0), new Vec3(0.01, 0.01, 0.01))
                .impostor(SHAPE, null)
                .level();
        View view = view(0.8 * BEGIN, 0.3, 0.5);
        int[] near = ids(level, view, IMPOSTORS);
        int[] there = ids(moved, towards(view.eye().plus(far), far), IMPOSTORS);
        assertTrue(differing(near, there) < 12);
    }
}
