package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;

/**
 * A test picture that shows the orientation of texture coordinates: 8 × 8 cells, numbered 1–64 from the lower left
 * corner to the right and upwards, each with an arrow that points up. The left edge is red, the right green, the bottom
 * yellow, the top blue.
 */
final class NumberedGrid {
    public static final int DIGIT_WIDTH = 5;
    static final int DIGIT_HEIGHT = 7;
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

    static final String FILE = "textures/test/numbered-grid.png";

    private static final int CELLS = 8;
    private static final int CELL = 64;
    private static final int SIDE = CELLS * CELL;
    private static final int DOT = 4;
    private static final int EDGE = 5;
    private static final PaintColour INK = PaintColour.of(0x14181E);
    private static final PaintColour LEFT = PaintColour.of(0xD8342C);
    private static final PaintColour RIGHT = PaintColour.of(0x27A35A);
    private static final PaintColour BOTTOM = PaintColour.of(0xF0C020);
    private static final PaintColour TOP = PaintColour.of(0x2F62D8);

    private NumberedGrid() {}

    static BufferedImage paint() {
        return Pixels.picture(SIDE, SIDE, (x, y) -> colour(x, y).rgb());
    }

    private static PaintColour colour(int x, int y) {
        if (x < EDGE || x >= SIDE - EDGE) {
            return x < EDGE ? LEFT : RIGHT;
        }
        if (y < EDGE || y >= SIDE - EDGE) {
            return y < EDGE ? TOP : BOTTOM;
        }
        int column = x / CELL;
        int row = CELLS - 1 - y / CELL;
        int inX = x % CELL;
        int inY = y % CELL;
        boolean inked = isNumber(1 + row * CELLS + column, inX, inY) || isArrow(inX, inY);
        return inked ? INK : ground(column, row);
    }

    /** Returns a cell's background: warmer to the right, brighter upwards, with a chequer that separates neighbours. */
    private static PaintColour ground(int column, int row) {
        PaintColour cold = PaintColour.of(0x9CC3E6);
        PaintColour warm = PaintColour.of(0xF2B48A);
        double up = (row + 0.5) / CELLS;
        double chequer = (column + row) % 2 == 0 ? 1 : 0.86;
        return cold.mix(warm, (column + 0.5) / CELLS).times((0.72 + 0.28 * up) * chequer);
    }

    private static boolean isNumber(int number, int x, int y) {
        int left = (CELL - (2 * DIGIT_WIDTH + 1) * DOT) / 2;
        int top = 28;
        int dotX = Math.floorDiv(x - left, DOT);
        int dotY = Math.floorDiv(y - top, DOT);
        return hasDot(number / 10, dotX, dotY) || hasDot(number % 10, dotX - DIGIT_WIDTH - 1, dotY);
    }

    private static boolean isArrow(int x, int y) {
        double away = Math.abs(x + 0.5 - CELL / 2.0);
        boolean head = y >= 8 && y < 18 && away <= y - 7;
        boolean shaft = y >= 18 && y < 24 && away <= 2.5;
        return head || shaft;
    }

    /** Returns true if the digit has a dot at x and y, which count from its upper left corner; false outside. */
    public static boolean hasDot(int digit, int x, int y) {
        boolean inside = x >= 0 && x < DIGIT_WIDTH && y >= 0 && y < DIGIT_HEIGHT;
        return inside && DIGITS[digit].charAt(y * (DIGIT_WIDTH + 1) + x) == '1';
    }
}
