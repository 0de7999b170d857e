package nephele.workshop.art.paint;

/** Digits of 5 × 7 dots. Unlike fonts they are the same on every machine. */
public final class PixelLetters {
    public static final int WIDTH = 5;
    static final int HEIGHT = 7;

    private static final String[] DIGITS = {
        "01110 10001 10011 10101 11001 10001 01110",
        "00100 01100 00100 00100 00100 00100 01110",
        "01110 10001 00001 00010 00100 01000 11111",
        "11111 00010 00100 00010 00001 10001 01110",
        "00010 00110 01010 10010 11111 00010 00010",
        "11111 10000 11110 00001 00001 10001 01110",
        "00110 01000 10000 11110 10001 10001 01110",
        "11111 00001 00010 00100 01000 01000 01000",
        "01110 10001 10001 01110 10001 10001 01110",
        "01110 10001 10001 01111 00001 00010 01100"
    };

    private PixelLetters() {}

    /** Returns true if the digit has a dot at x and y, which count from its upper left corner; false outside. */
    public static boolean hasDot(int digit, int x, int y) {
        boolean inside = x >= 0 && x < WIDTH && y >= 0 && y < HEIGHT;
        return inside && DIGITS[digit].charAt(y * (WIDTH + 1) + x) == '1';
    }
}
