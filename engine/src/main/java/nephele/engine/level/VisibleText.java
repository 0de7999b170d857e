package nephele.engine.level;

/** What of a text a reader can see, by the categories of Unicode. */
final class VisibleText {
    /** Letters that are drawn as nothing (Hangul fillers) and the empty Braille pattern. */
    private static final String BLANK_LETTERS = "\u115f\u1160\u3164\uffa0\u2800";

    private VisibleText() {}

    /** Control and format characters, among them those that turn the direction of writing, and ends of lines. */
    static boolean isInvisible(char c) {
        int type = Character.getType(c);
        return type == Character.CONTROL
                || type == Character.FORMAT
                || type == Character.LINE_SEPARATOR
                || type == Character.PARAGRAPH_SEPARATOR;
    }

    /** Whether there is nothing to see but space. */
    static boolean isBlank(String text) {
        return text.chars()
                .allMatch(c -> Character.isWhitespace(c)
                        || Character.isSpaceChar(c)
                        || isInvisible((char) c)
                        || BLANK_LETTERS.indexOf(c) >= 0);
    }
}
