package nephele.lab.technique;

import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;
import nephele.lab.bench.CalibrationDrawing;

/** The CPU time that the clouds of a sky add to a frame. */
final class CloudCost {
    private static final int FRAMES = 3;
    private static final int ROUNDS = 2;
    private static final int CALIBRATION_FRAMES = 40;

    private CloudCost() {}

    /**
     * Returns it in those of the quad of {@code bench --calibrate}, the least of some rounds.
     *
     * @param placed the sky's level with the techniques that are timed
     */
    static double of(GlContext gl, SeenSky sky, PlacedLevel placed, Stopwatch watch) {
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
            for (int round = 0; round < ROUNDS; round++) {
                double clouds = with.nanosAFrame(FRAMES, watch);
                double none = without.nanosAFrame(FRAMES, watch);
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
