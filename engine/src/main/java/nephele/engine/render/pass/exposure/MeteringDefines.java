package nephele.engine.render.pass.exposure;

import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.render.frame.Defines;

/** The numbers of the Java twins for their shaders. */
final class MeteringDefines {
    /** Values of cells without luminance, far below any logarithm. */
    private static final double BLACK = -1000;

    private static final double HIDDEN = -2000;

    private MeteringDefines() {}

    static Defines all() {
        return new Defines()
                .with("COLUMNS", LuminanceHistogram.COLUMNS)
                .with("ROWS", LuminanceHistogram.ROWS)
                .with("SAMPLES", LuminanceHistogram.SAMPLES)
                .with("DARKEST_LOG2", (double) LuminanceHistogram.DARKEST_LOG2)
                .with("BINS_PER_STOP", (double) LuminanceHistogram.BINS_PER_STOP)
                .with("BINS", (double) LuminanceHistogram.BINS)
                .with("STEPS", (double) LuminanceHistogram.STEPS)
                .with("LOW_SHARE", LuminanceHistogram.LOW_SHARE)
                .with("HIGH_SHARE", LuminanceHistogram.HIGH_SHARE)
                .with("DISPLAYED_PER_KEY", AutoExposure.DISPLAYED_PER_KEY)
                .with("CANDELAS_PER_SQUARE_METRE", AutoExposure.CANDELAS_PER_SQUARE_METRE)
                .with("BLACK", BLACK)
                .with("HIDDEN", HIDDEN)
                .with("EXPOSURE_METERED");
    }
}
