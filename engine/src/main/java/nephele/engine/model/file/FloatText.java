package nephele.engine.model.file;

import java.math.BigDecimal;
import java.math.MathContext;

/** Formats a float as a decimal that reads back to the same float, independent of Java version and locale. */
public final class FloatText {
    private static final double[] TENS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    private static final int ENOUGH_DIGITS = 9;

    private FloatText() {}

    /** @throws IllegalArgumentException for NaN and infinities, which no file may contain */
    public static String of(float value) {
        if (!Float.isFinite(value)) {
            throw new IllegalArgumentException(value + " has no place in a file");
        }
        float magnitude = Math.abs(value);
        String sign = value < 0 || 1 / value < 0 ? "-" : "";
        return sign
                + (magnitude == 0 ? "0" : magnitude >= 1e-3f && magnitude < 1e6f ? plain(magnitude) : any(magnitude));
    }

    private static String plain(float magnitude) {
        for (int decimals = 0; decimals < TENS.length; decimals++) {
            long digits = Math.round(magnitude * TENS[decimals]);
            if ((float) (digits / TENS[decimals]) == magnitude) {
                String text = layout(digits, decimals);
                if (Float.parseFloat(text) == magnitude) {
                    return text;
                }
            }
        }
        return any(magnitude);
    }

    private static String layout(long digits, int decimals) {
        if (decimals == 0) {
            return Long.toString(digits);
        }
        long whole = digits / (long) TENS[decimals];
        String rest = Long.toString(digits % (long) TENS[decimals]);
        return whole + "." + "0".repeat(decimals - rest.length()) + rest;
    }

    /**
     * Tries 6 to 9 significant digits, from 1 digit for subnormals. Every decimal of six digits survives a normal float
     * (Matula 1968), so a shorter text is the six-digit one without trailing zeros.
     */
    private static String any(float magnitude) {
        BigDecimal exact = new BigDecimal(magnitude);
        for (int digits = magnitude < Float.MIN_NORMAL ? 1 : 6; digits < ENOUGH_DIGITS; digits++) {
            String text = text(exact, digits);
            if (Float.parseFloat(text) == magnitude) {
                return text;
            }
        }
        return text(exact, ENOUGH_DIGITS);
    }

    private static String text(BigDecimal exact, int digits) {
        return exact.round(new MathContext(digits)).stripTrailingZeros().toString();
    }
}
