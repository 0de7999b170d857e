package nephele.lab.technique;

import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LevelLight;
import nephele.lab.bench.CalibrationDrawing;

/** A sky drawn by a technique: its picture, and the time that it takes. */
public final class DrawnSky implements AutoCloseable {
    /** CPU time of a round: its clock advances in steps of 10 ms. */
    private static final double ROUND_NANOS = 0.4e9;

    private static final int ROUNDS = 2;
    private static final int MOST_FRAMES = 40;
    private static final int CALIBRATION_FRAMES = 200;

    /** Pixels of a timed picture along each side for one of the traced. */
    static final int TIMED = 16;

    private static final double STRIDE_METRES = 0.1;

    private final GlContext gl;
    private final SkyView sky;
    private final RenderTarget target;
    private final Renderer renderer;

    private DrawnSky(GlContext gl, SkyView sky, PlacedLevel placed, Quality quality, int scale) {
        this.gl = gl;
        this.sky = sky;
        Scene scene = Scene.of(placed, LevelLight.of(placed, done -> {}));
        renderer = LevelRenderer.load(gl, scene, RenderSettings.of(Output.HDR, quality));
        target = RenderTarget.picture(gl, "sky", PixelFormat.RGBA8, scale * SkyView.WIDTH, scale * SkyView.HEIGHT);
    }

    /** Returns the radiance that a level with the sky's clouds shows at its best, each pixel the mean of four by four. */
    public static LinearPicture picture(GlContext gl, SkyView sky, PlacedLevel placed) {
        return picture(gl, sky, placed, Quality.ULTRA);
    }

    /** Returns the radiance at a quality, each pixel the mean of four by four. */
    public static LinearPicture picture(GlContext gl, SkyView sky, PlacedLevel placed, Quality quality) {
        int scale = 4;
        try (var drawn = new DrawnSky(gl, sky, placed, quality, scale)) {
            drawn.draw(1);
            float[] radiance = drawn.renderer.readRadiance();
            return new LinearPicture(drawn.target.width(), drawn.target.height(), radiance).reduced(scale);
        }
    }

    /** A sky that is drawn again and again, at quality high, 640 pixels wide. */
    static DrawnSky timed(GlContext gl, SkyView sky, PlacedLevel placed) {
        return new DrawnSky(gl, sky, placed, Quality.HIGH, TIMED);
    }

    /** Returns the CPU time of the process a frame, nanoseconds, while the eye moves a little. */
    double nanosAFrame(int frames, Stopwatch watch) {
        draw(1);
        long before = watch.processCpuNanos();
        draw(frames);
        return (double) (watch.processCpuNanos() - before) / frames;
    }

    private void draw(int frames) {
        View view = sky.view();
        for (int frame = 0; frame < frames; frame++) {
            Vec3 eye = view.eye().addScaled(STRIDE_METRES * frame, view.right());
            renderer.draw(new View(eye, view.right(), view.up(), view.back(), view.projection()), target);
        }
        gl.finish();
        gl.requireNoError("sky");
    }

    @Override
    public void close() {
        renderer.close();
        target.close();
    }

    /**
     * Returns the CPU time that the clouds of a sky add to a frame, in quads of {@code bench --calibrate}: the least of some
     * rounds.
     *
     * @param placed the sky's level with the techniques that are timed
     */
    public static double cloudCost(GlContext gl, SkyView sky, PlacedLevel placed, Stopwatch watch) {
        PlacedLevel clear = PlacedLevel.of(
                sky.level()
                        .with(
                                sky.level().environment().withoutClouds(),
                                sky.level().lights()),
                sky.assets());
        double least = Double.POSITIVE_INFINITY;
        try (var with = timed(gl, sky, placed);
                var without = timed(gl, sky, clear);
                var quad = new CalibrationDrawing(gl, TIMED * SkyView.WIDTH, TIMED * SkyView.HEIGHT)) {
            double once = Math.max(1, with.nanosAFrame(1, watch));
            int frames = (int) Math.max(1, Math.min(MOST_FRAMES, Math.ceil(ROUND_NANOS / once)));
            for (int round = 0; round < ROUNDS; round++) {
                double clouds = with.nanosAFrame(frames, watch);
                double none = without.nanosAFrame(frames, watch);
                least = Math.min(least, Math.max(0, clouds - none) / quadNanos(gl, quad, watch));
            }
        }
        return least;
    }

    private static double quadNanos(GlContext gl, CalibrationDrawing quad, Stopwatch watch) {
        long before = watch.processCpuNanos();
        for (int frame = 0; frame < CALIBRATION_FRAMES; frame++) {
            quad.draw(frame);
        }
        gl.finish();
        return (double) (watch.processCpuNanos() - before) / CALIBRATION_FRAMES;
    }
}
