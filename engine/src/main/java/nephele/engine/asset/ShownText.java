package nephele.engine.asset;

/** Texts as messages show them: what comes from a file may be as long as the file. */
public final class ShownText {
    private static final int MOST = 600;
    private static final int LAST = 150;

    private ShownText() {}

    /** The text, or its beginning and its end. */
    public static String shortened(String text) {
        if (text == null || text.length() <= MOST) {
            return text;
        }
        return text.substring(0, MOST - LAST - 1) + "…" + text.substring(text.length() - LAST);
    }
}
