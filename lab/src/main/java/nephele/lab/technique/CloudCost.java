package nephele.lab.technique;

import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;
import nephele.lab.bench.CalibrationDrawing;

/** The CPU time that the clouds of a sky add to a frame. */
public final class CloudCost {
    /** CPU time of a round: its clock advances in steps of 10 ms. */
    private static final double ROUND_NANOS = 0.4e9;

    private static final int ROUNDS = 2;
    private static final int MOST_FRAMES = 40;
    private static final int CALIBRATION_FRAMES = 200;

    private CloudCost() {}

    /**
     * Returns it in those of the quad of {@code bench --calibrate}, the least of some rounds.
     *
     * @param placed the sky's level with the techniques that are timed
     */
    public static double of(GlContext gl, SeenSky sky, PlacedLevel placed, Stopwatch watch) {
        PlacedLevel clear = PlacedLevel.of(
                sky.level()
                        .with(
                                sky.level().environment().withoutClouds(),
                                sky.level().lights()),
                sky.assets());
        double least = Double.POSITIVE_INFINITY;
        try (var with = DrawnSky.timed(gl, sky, placed);
                var without = DrawnSky.timed(gl, sky, clear);
                var quad =
                        new CalibrationDrawing(gl, DrawnSky.TIMED * SeenSky.WIDTH, DrawnSky.TIMED * SeenSky.HEIGHT)) {
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
