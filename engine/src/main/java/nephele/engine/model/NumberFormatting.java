package nephele.engine.model;

/** Formats numbers for messages: integers without a decimal point. */
public final class NumberFormatting {
    private static final double LONGEST = 1e15;

    private NumberFormatting() {}

    public static String of(double value) {
        return isWhole(value) ? Long.toString((long) value) : Double.toString(value);
    }

    /** Formats a float; as a double it would show digits that were not written. */
    public static String of(float value) {
        return isWhole(value) ? Long.toString((long) value) : Float.toString(value);
    }

    private static boolean isWhole(double value) {
        return value == Math.rint(value) && Math.abs(value) < LONGEST;
    }
}
