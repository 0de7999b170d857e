package nephele.engine.render.pass.overlay;

import java.util.ArrayList;
import java.util.List;

/**
 * A letter as the path of a pen, in hundredths of an em above the baseline.
 *
 * @param widthHundredths from the leftmost to the rightmost pen position, without the pen's own width
 * @param strokes rows of points x0, y0, x1, y1 …
 */
record Glyph(int codePoint, double widthHundredths, List<double[]> strokes) {
    /**
     * Returns this letter with the strokes of another one centred on it, raised by {@code lift}; as wide as the wider
     * of both.
     */
    Glyph with(Glyph mark, int newCodePoint, double lift) {
        double width = Math.max(widthHundredths, mark.widthHundredths);
        var all = new ArrayList<double[]>();
        strokes.forEach(stroke -> all.add(moved(stroke, (width - widthHundredths) / 2, 0)));
        mark.strokes.forEach(stroke -> all.add(moved(stroke, (width - mark.widthHundredths) / 2, lift)));
        return new Glyph(newCodePoint, width, all);
    }

    private static double[] moved(double[] stroke, double dx, double dy) {
        var moved = stroke.clone();
        for (int i = 0; i < moved.length; i += 2) {
            moved[i] += dx;
            moved[i + 1] += dy;
        }
        return moved;
    }
}
