package nephele.engine.model;

/** Parses decimals such as -12.5 from bytes, faster than from strings and with the same result to the last bit. */
final class PlainDecimal {
    /** Integers of more digits may not fit into a double's 53 bits. */
    private static final int MOST_DIGITS = 15;

    private static final double[] TENS = tens();

    /** The mantissa bits that a double has and a float has not, and their value halfway between two floats. */
    private static final long BEYOND_FLOAT = (1L << 29) - 1;

    private static final long HALFWAY = 1L << 28;

    private PlainDecimal() {}

    private static double[] tens() {
        double[] tens = new double[MOST_DIGITS + 1];
        tens[0] = 1;
        for (int i = 1; i <= MOST_DIGITS; i++) {
            tens[i] = 10 * tens[i - 1];
        }
        return tens;
    }

    /** Parses a decimal; NaN if it is malformed, has an exponent or too many digits, or needs exact rounding. */
    static float read(byte[] bytes, int start, int end) {
        boolean signed = start < end && (bytes[start] == '-' || bytes[start] == '+');
        long digits = 0;
        int count = 0;
        int decimals = -1;
        for (int i = signed ? start + 1 : start; i < end; i++) {
            int digit = bytes[i] - '0';
            if (digit >= 0 && digit <= 9) {
                digits = 10 * digits + digit;
                count++;
                decimals += decimals >= 0 ? 1 : 0;
            } else if (bytes[i] == '.' && decimals < 0) {
                decimals = 0;
            } else {
                return Float.NaN;
            }
            if (count > MOST_DIGITS) {
                return Float.NaN;
            }
        }
        float magnitude = count == 0 ? Float.NaN : decimals <= 0 ? (float) digits : rounded(digits / TENS[decimals]);
        return signed && bytes[start] == '-' ? -magnitude : magnitude;
    }

    /**
     * Rounds a quotient to a float, NaN if this may be inexact. The quotient of two exact doubles is rounded once, and
     * once more to a float; this is wrong at most if the first result is halfway between two floats (Clinger 1990).
     */
    private static float rounded(double quotient) {
        boolean isHalfway = (Double.doubleToRawLongBits(quotient) & BEYOND_FLOAT) == HALFWAY;
        boolean isNormal = quotient == 0 || quotient >= Float.MIN_NORMAL;
        return isNormal && !isHalfway ? (float) quotient : Float.NaN;
    }
}
