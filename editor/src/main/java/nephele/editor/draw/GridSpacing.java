package nephele.editor.draw;

import java.math.BigDecimal;
import java.math.RoundingMode;

/**
 * The distances of a plan's lines at one zoom, in metres.
 *
 * @param minorMetres the grid's own spacing if there is room, otherwise a power of two of it
 * @param labelMetres a multiple of {@code majorMetres}
 */
record GridSpacing(double minorMetres, double majorMetres, double labelMetres) {
    private static final double LEAST_MINOR_PIXELS = 8;
    private static final double LEAST_LABEL_PIXELS = 72;
    private static final int MINOR_PER_MAJOR = 8;

    /** @param pixelsPerPoint enlarges the least distances */
    static GridSpacing of(double gridMetres, double metresPerPixel, double pixelsPerPoint) {
        double metresPerPoint = metresPerPixel * pixelsPerPoint;
        double minor = doubled(gridMetres, LEAST_MINOR_PIXELS * metresPerPoint);
        double major = MINOR_PER_MAJOR * minor;
        return new GridSpacing(minor, major, doubled(major, LEAST_LABEL_PIXELS * metresPerPoint));
    }

    private static double doubled(double metres, double least) {
        double factor = Math.max(0, Math.ceil(Math.log(least / metres) / Math.log(2)));
        return metres * Math.pow(2, factor);
    }

    /** Returns metres as a short decimal number. */
    static String text(double metres) {
        BigDecimal rounded = BigDecimal.valueOf(metres).setScale(4, RoundingMode.HALF_EVEN);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}
