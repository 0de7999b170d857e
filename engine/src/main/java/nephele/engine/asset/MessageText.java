package nephele.engine.asset;

import java.util.regex.Pattern;

/** Texts from files in messages: shortened, without control characters, and equal messages are counted. */
public final class MessageText {
    private static final int MOST = 600;
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

    /** Returns the text, or its beginning and end with at most 600 characters; {@code null} for {@code null}. */
    public static String shortened(String text) {
        if (text == null || text.length() <= MOST) {
            return text;
        }
        return text.substring(0, MOST - LAST - 1) + "…" + text.substring(text.length() - LAST);
    }
}
