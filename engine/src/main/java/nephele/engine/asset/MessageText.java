package nephele.engine.asset;

import java.util.regex.Pattern;

/** Texts and numbers from files in messages: shortened, without control characters, and equal messages are counted. */
public final class MessageText {
    private static final int MOST = 600;
    private static final double LONGEST_WHOLE = 1e15;
    private static final int LAST = 150;

    /** Controls, formatting characters, halves of pairs, private and unassigned ones, and line separators. */
    private static final Pattern UNPRINTABLE = Pattern.compile("[\\p{C}\\p{Zl}\\p{Zp}]");

    private MessageText() {}

    /** Returns text as it is spelt, but for characters that could control a terminal or turn the text around. */
    public static String printable(String text) {
        return UNPRINTABLE.matcher(text).replaceAll("?");
    }

    /** Returns what follows a message that stands for several equal ones, such as " (700 times)"; empty for one. */
    public static String times(int count) {
        return count == 1 ? "" : " (" + count + " times)";
    }

    /** Returns a number without a decimal point if it is whole. */
    public static String number(double value) {
        return isWhole(value) ? Long.toString((long) value) : Double.toString(value);
    }

    /** Returns a number likewise; as a double it would have digits that were not written. */
    public static String number(float value) {
        return isWhole(value) ? Long.toString((long) value) : Float.toString(value);
    }

    private static boolean isWhole(double value) {
        return value == Math.rint(value) && Math.abs(value) < LONGEST_WHOLE;
    }

    /** Returns the text, or its beginning and end with at most 600 characters; {@code null} for {@code null}. */
    public static String shortened(String text) {
        if (text == null || text.length() <= MOST) {
            return text;
        }
        return text.substring(0, MOST - LAST - 1) + "…" + text.substring(text.length() - LAST);
    }
}
