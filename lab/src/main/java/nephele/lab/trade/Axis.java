package nephele.lab.trade;

import java.util.ArrayList;
import java.util.List;

/**
 * A map from values to pixels. An error axis begins at zero, so that small errors look small. A cost axis begins near
 * the least cost if all are similar, and is logarithmic if they differ by more than a factor of {@link #TOO_MUCH}.
 *
 * @param low value at {@code start}
 * @param high value at {@code end}
 */
record Axis(double low, double high, double start, double end, boolean isLogarithmic) {
    private static final double TOO_MUCH = 40;
    private static final int TICKS = 5;
    /** The ratio of the least to the greatest cost above which the axis does not begin at zero. */
    private static final double ALIKE = 0.4;

    static Axis ofErrors(double most, double start, double end) {
        return new Axis(0, most > 0 ? most * 1.12 : 1, start, end, false);
    }

    static Axis ofCosts(double least, double most, double start, double end) {
        if (least > 0 && most / least > TOO_MUCH) {
            return new Axis(Math.pow(10, Math.floor(Math.log10(least))), most * 1.3, start, end, true);
        }
        double margin = 0.12 * Math.max(most - least, 0.05 * most);
        return new Axis(least > ALIKE * most ? least - margin : 0, most + margin, start, end, false);
    }

    double pixel(double value) {
        double fraction = isLogarithmic
                ? Math.log(Math.max(value, low) / low) / Math.log(high / low)
                : (value - low) / (high - low);
        return start + fraction * (end - start);
    }

    /** Returns round values: spaced by 1, 2 or 5 times a power of ten, or powers of ten on a logarithmic axis. */
    List<Double> ticks() {
        List<Double> ticks = new ArrayList<>();
        if (isLogarithmic) {
            for (double tick = low; tick <= high; tick *= 10) {
                ticks.add(tick);
            }
            return ticks;
        }
        double raw = (high - low) / TICKS;
        double power = Math.pow(10, Math.floor(Math.log10(raw)));
        double step = raw / power > 5 ? 10 * power : raw / power > 2 ? 5 * power : raw / power > 1 ? 2 * power : power;
        for (int i = (int) Math.ceil(low / step); i * step <= high; i++) {
            ticks.add(i * step);
        }
        return ticks;
    }
}
