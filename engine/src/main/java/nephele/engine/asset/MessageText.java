package nephele.engine.asset;

/** Texts from files in messages: shortened, without control characters, and equal messages are counted. */
public final class MessageText {
    private static final int MOST = 600;
    private static final int LAST = 150;

    private MessageText() {}

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

    /** Returns the text with all letters of all scripts; what shows nothing or steers a terminal becomes "?". */
    public static String printable(String text) {
        if (text.chars().allMatch(c -> c >= ' ' && c <= '~')) {
            return text;
        }
        StringBuilder shown = new StringBuilder(text.length());
        text.codePoints().forEach(c -> shown.appendCodePoint(shows(c) ? c : '?'));
        return shown.toString();
    }

    private static boolean shows(int codePoint) {
        return switch (Character.getType(codePoint)) {
            case Character.CONTROL,
                    Character.FORMAT,
                    Character.SURROGATE,
                    Character.PRIVATE_USE,
                    Character.UNASSIGNED,
                    Character.LINE_SEPARATOR,
                    Character.PARAGRAPH_SEPARATOR -> false;
            default -> true;
        };
    }
}
