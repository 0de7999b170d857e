package nephele.engine.reference;

import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.level.placed.PlacedLevel;

/**
 * Replaces exposure auto by the stops that the picture of an eye calls for, metered from a small traced picture. A pixel
 * alone cannot be metered, and the curtain of an exit has the same display value at every exposure, so its radiance is
 * known only after the metering.
 */
public final class TracedExposure {
    /** Four pixels for each cell of {@link LuminanceHistogram}. */
    private static final int WIDTH = 2 * LuminanceHistogram.COLUMNS;

    private static final int HEIGHT = 2 * LuminanceHistogram.ROWS;
    private static final int SAMPLES = 4;

    private TracedExposure() {}

    /** Returns true if the radiance of a level depends on its exposure, and that on its picture. */
    public static boolean isNeeded(Level level) {
        return level.environment().exposureStops().isAuto() && !level.exits().isEmpty();
    }

    /**
     * Returns the level with a number of stops; the same level if it has one.
     *
     * @param seconds simulated time at which the picture is metered; the returned level is still that of time 0
     */
    public static PlacedLevel fixed(PlacedLevel placed, ColourDecoding decoding, Pinhole eye, double seconds) {
        Environment environment = placed.level().environment();
        if (!environment.exposureStops().isAuto()) {
            return placed;
        }
        int threads = Runtime.getRuntime().availableProcessors();
        TraceSettings settings = new TraceSettings(WIDTH, HEIGHT, SAMPLES, 1, threads);
        PlacedLevel then = new PlacedLevel(Daylight.lit(placed.level(), seconds), placed.assets(), placed.statics());
        float[] rgb = ReferencePicture.trace(TracedLevel.of(then, decoding, seconds), eye, settings, fraction -> {});
        Exposure metered = Exposure.ofStops(AutoExposure.stops(environment, rgb, WIDTH));
        Level level = placed.level();
        return placed.edited(level.with(environment.with(metered), level.lights()));
    }
}
