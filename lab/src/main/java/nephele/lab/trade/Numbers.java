package nephele.lab.trade;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import nephele.engine.measure.Interval;

/** Formats numbers for the report. */
public final class Numbers {
    private static final MathContext THREE_DIGITS = new MathContext(3, RoundingMode.HALF_EVEN);
    private static final double SMALLEST_PLAIN = 1e-4;
    /** A smaller magnitude is rounding error and is written as 0. */
    private static final double NOTHING = 1e-9;

    private Numbers() {}

    /** Formats with three significant digits; tiny values with a power of ten. */
    public static String of(double value) {
        if (Math.abs(value) < NOTHING) {
            return "0";
        }
        if (Math.abs(value) < SMALLEST_PLAIN) {
            return String.format(Locale.ROOT, "%.0e", value).replace("e-0", "e-");
        }
        var rounded = new BigDecimal(value).round(THREE_DIGITS);
        return rounded.scale() < 0 ? rounded.setScale(0).toPlainString() : rounded.toPlainString();
    }

    static String of(double value, String unit) {
        return unit.isEmpty() ? of(value) : of(value) + "\u00a0" + unit;
    }

    /** Formats a chosen value exactly, without rounding. */
    static String chosen(double value, String unit) {
        String plain = BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
        return unit.isEmpty() ? plain : plain + "\u00a0" + unit;
    }

    /** Formats a fraction as whole per cent. */
    static String percent(double fraction) {
        return String.format(Locale.ROOT, "%.0f %%", 100 * fraction);
    }

    /** Formats a factor with two decimals below 10, one below 100, none above. */
    static String ratio(double value) {
        return String.format(Locale.ROOT, value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : "%.2f", value);
    }

    static String ratio(Interval interval) {
        return ratio(interval.low()) + "–" + ratio(interval.high());
    }

    static String range(Interval interval) {
        return of(interval.low()) + "–" + of(interval.high());
    }
}
