package nephele.engine.model;

/** Numbers as messages show them: whole ones as people write them, without a point. */
public final class ShownNumber {
    private static final double LONGEST = 1e15;

    private ShownNumber() {}

    public static String of(double value) {
        return isWhole(value) ? Long.toString((long) value) : Double.toString(value);
    }

    /** As of a double it would have digits that nobody wrote. */
    static String of(float value) {
        return isWhole(value) ? Long.toString((long) value) : Float.toString(value);
    }

    private static boolean isWhole(double value) {
        return value == Math.rint(value) && Math.abs(value) < LONGEST;
    }
}
