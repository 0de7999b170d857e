package nephele.engine.level.json;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * The shortest decimal text that reads back to the same double, in ECMAScript's notation (RFC 8785, 3.2.2.3) except
 * that negative zero keeps its sign. {@code Double.toString} is longer before Java 19 and differs since.
 */
public final class NumberText {
    private static final double EXACT_INTEGERS = 1L << 53;
    private static final double[] TENS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    private static final double LOG10_OF_2 = 0.30102999566398120;

    /** Precision for exact values of up to 767 digits; the later digits never change the result. */
    private static final MathContext ENOUGH = new MathContext(40);

    private static final RoundingMode[] NEIGHBOURS = {RoundingMode.HALF_EVEN, RoundingMode.DOWN, RoundingMode.UP};

    private NumberText() {}

    /**
     * Returns the text of a number.
     *
     * @throws IllegalArgumentException for NaN and infinities, which JSON cannot hold
     */
    public static String of(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("JSON has no text for " + value);
        }
        if (value == 0) {
            return 1 / value < 0 ? "-0" : "0";
        }
        double magnitude = Math.abs(value);
        String text = magnitude == Math.rint(magnitude) && magnitude < EXACT_INTEGERS
                ? Long.toString((long) magnitude)
                : magnitude >= 1e-3 && magnitude < 1e6 ? fewDecimals(magnitude) : general(magnitude);
        return value < 0 ? "-" + text : text;
    }

    /**
     * Returns the text of a number with up to nine decimals, the usual case: m / 10^k is correctly rounded, so it
     * equals the value exactly if the text "m · 10^-k" reads back to it.
     */
    private static String fewDecimals(double magnitude) {
        for (int k = 1; k < TENS.length; k++) {
            long m = Math.round(magnitude * TENS[k]);
            if (m < EXACT_INTEGERS && m / TENS[k] == magnitude) {
                return layout(Long.toString(m), Long.toString(m).length() - k);
            }
        }
        return general(magnitude);
    }

    /**
     * Rounds the exact value to ever more digits, to nearest first, until the text reads back. Every decimal of ⌊(p −
     * 1) log10 2⌋ digits survives a double of p bits (Matula 1968), so a shorter text is those digits without trailing
     * zeros.
     */
    private static String general(double magnitude) {
        int bits = magnitude < Double.MIN_NORMAL
                ? Long.SIZE - Long.numberOfLeadingZeros(Double.doubleToRawLongBits(magnitude))
                : 53;
        int alwaysHeld = (int) ((bits - 1) * LOG10_OF_2);
        BigDecimal exact = new BigDecimal(magnitude, ENOUGH);
        for (int digits = Math.max(1, alwaysHeld); digits <= 17; digits++) {
            for (RoundingMode mode : NEIGHBOURS) {
                BigDecimal rounded = exact.round(new MathContext(digits, mode));
                if (Double.parseDouble(rounded.toString()) == magnitude) {
                    BigDecimal plain = rounded.stripTrailingZeros();
                    String unscaled = plain.unscaledValue().toString();
                    return layout(unscaled, unscaled.length() - plain.scale());
                }
            }
        }
        throw new IllegalStateException("17 digits always suffice");
    }

    /** @param point the number of digits before the decimal point */
    private static String layout(String digits, int point) {
        if (digits.length() <= point && point <= 21) {
            return digits + "0".repeat(point - digits.length());
        }
        if (0 < point && point <= 21) {
            return digits.substring(0, point) + "." + digits.substring(point);
        }
        if (-6 < point && point <= 0) {
            return "0." + "0".repeat(-point) + digits;
        }
        String exponent = (point > 0 ? "e+" : "e-") + Math.abs(point - 1);
        return digits.charAt(0) + (digits.length() == 1 ? "" : "." + digits.substring(1)) + exponent;
    }
}
