package nephele.engine.render.pass.overlay;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * The letters as one signed distance field, drawn at the first text, so that a game without an overlay has none. It is 128 on the edge of the pen's line, rising inside, one step for 1/{@link
 * #STEPS_PER_TEXEL} texel. The distance to a polyline is computed exactly, without a search. One field serves every
 * size (Green 2007, "Improved Alpha-Tested Magnification").
 */
public final class FontAtlas {
    static final int WIDTH_TEXELS = 768;
    static final double TEXELS_PER_EM = 56;
    static final int STEPS_PER_TEXEL = 24;

    /** Free texels around a letter: the range of the field, so that adjacent letters never mix. */
    static final int MARGIN_TEXELS = 6;

    /** Side of a square block of texels that are fully inside; fills panels. */
    static final int SOLID_TEXELS = 4;

    private static final double LOWEST_HUNDREDTHS = -26;
    private static final double HIGHEST_HUNDREDTHS = 100;

    private final Map<Integer, Cell> cells = new HashMap<>();
    /** {@code null} before the first text. */
    private byte[] texels;

    private int height;

    /** The place of a letter in the atlas, and the advance of the pen; the origin is the pen on the baseline. */
    record Cell(int x, int y, int width, int height, double advanceEm) {}

    /** Creates an atlas without letters. */
    public FontAtlas() {}

    static FontAtlas of(StrokeFont font) {
        var atlas = new FontAtlas();
        atlas.draw(font);
        return atlas;
    }

    private void drawOnce() {
        if (texels == null) {
            draw(StrokeFont.load());
        }
    }

    private void draw(StrokeFont font) {
        layOut(font);
        texels = new byte[WIDTH_TEXELS * height];
        for (int row = 0; row < SOLID_TEXELS; row++) {
            Arrays.fill(texels, row * WIDTH_TEXELS, row * WIDTH_TEXELS + SOLID_TEXELS, (byte) 255);
        }
        for (var glyph : font.glyphs()) {
            draw(glyph, cells.get(glyph.codePoint()));
        }
    }

    int height() {
        drawOnce();
        return height;
    }

    byte[] texels() {
        drawOnce();
        return texels;
    }

    /** Returns the letter's cell, or the question mark's for letters that the font lacks. */
    Cell cell(int codePoint) {
        drawOnce();
        var cell = cells.get(codePoint);
        return cell != null ? cell : cells.get((int) '?');
    }

    /** Returns the advance of a letter. */
    double advanceEm(int codePoint) {
        return codePoint == ' ' ? StrokeFont.SPACE_EM : cell(codePoint).advanceEm();
    }

    /** Returns the texels from a cell's bottom edge to the baseline. */
    static double baselineTexels() {
        return MARGIN_TEXELS - LOWEST_HUNDREDTHS / 100 * TEXELS_PER_EM;
    }

    private void layOut(StrokeFont font) {
        int cellHeight =
                (int) Math.ceil((HIGHEST_HUNDREDTHS - LOWEST_HUNDREDTHS) / 100 * TEXELS_PER_EM) + 2 * MARGIN_TEXELS;
        int x = SOLID_TEXELS;
        int y = 0;
        for (var glyph : font.glyphs()) {
            int width = (int) Math.ceil((glyph.widthHundredths() + 2 * StrokeFont.PEN_HUNDREDTHS) / 100 * TEXELS_PER_EM)
                    + 2 * MARGIN_TEXELS;
            if (x + width > WIDTH_TEXELS) {
                x = 0;
                y += cellHeight;
            }
            double advance = (glyph.widthHundredths() + StrokeFont.SPACING_HUNDREDTHS) / 100;
            cells.put(glyph.codePoint(), new Cell(x, y, width, cellHeight, advance));
            x += width;
        }
        height = y + cellHeight;
    }

    /** Returns the texels from a cell's left edge to the pen's first position, one pen width right of the margin. */
    static double originTexels() {
        return MARGIN_TEXELS + StrokeFont.PEN_HUNDREDTHS / 100 * TEXELS_PER_EM;
    }

    private void draw(Glyph glyph, Cell cell) {
        for (var stroke : glyph.strokes()) {
            for (int i = 0; i + 3 < stroke.length; i += 2) {
                var segment = new Segment(
                        originTexels() + stroke[i] / 100 * TEXELS_PER_EM,
                        baselineTexels() + stroke[i + 1] / 100 * TEXELS_PER_EM,
                        originTexels() + stroke[i + 2] / 100 * TEXELS_PER_EM,
                        baselineTexels() + stroke[i + 3] / 100 * TEXELS_PER_EM);
                draw(segment, cell);
            }
        }
    }

    private void draw(Segment segment, Cell cell) {
        double halfPen = StrokeFont.PEN_HUNDREDTHS / 200 * TEXELS_PER_EM;
        double reach = halfPen + 128.0 / STEPS_PER_TEXEL;
        int left = Math.max(0, (int) Math.floor(segment.left() - reach));
        int right = Math.min(cell.width - 1, (int) Math.ceil(segment.right() + reach));
        int bottom = Math.max(0, (int) Math.floor(segment.bottom() - reach));
        int top = Math.min(cell.height - 1, (int) Math.ceil(segment.top() + reach));
        for (int row = bottom; row <= top; row++) {
            int rowStart = (cell.y + row) * WIDTH_TEXELS + cell.x;
            for (int column = left; column <= right; column++) {
                double inside = halfPen - segment.distance(column + 0.5, row + 0.5);
                int value = (int) Math.max(0, Math.min(255, Math.round(128 + inside * STEPS_PER_TEXEL)));
                if (value > (texels[rowStart + column] & 255)) {
                    texels[rowStart + column] = (byte) value;
                }
            }
        }
    }

    /** A straight piece of a stroke in a cell's texels. */
    private record Segment(double x0, double y0, double x1, double y1) {
        double left() {
            return Math.min(x0, x1);
        }

        double right() {
            return Math.max(x0, x1);
        }

        double bottom() {
            return Math.min(y0, y1);
        }

        double top() {
            return Math.max(y0, y1);
        }

        double distance(double x, double y) {
            double dx = x1 - x0;
            double dy = y1 - y0;
            double lengthSquared = dx * dx + dy * dy;
            double along = lengthSquared == 0 ? 0 : ((x - x0) * dx + (y - y0) * dy) / lengthSquared;
            double clamped = Math.max(0, Math.min(1, along));
            double toX = x - (x0 + clamped * dx);
            double toY = y - (y0 + clamped * dy);
            return Math.sqrt(toX * toX + toY * toY);
        }
    }
}
