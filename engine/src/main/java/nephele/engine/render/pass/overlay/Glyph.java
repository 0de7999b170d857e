package nephele.engine.render.pass.overlay;

import java.util.ArrayList;
import java.util.List;

/**
 * A letter as the path of a pen, in hundredths of an em above the baseline.
 *
 * @param widthHundredths from the leftmost to the rightmost pen position, without the pen's own width
 * @param strokes each a row of points x0, y0, x1, y1 …
 */
record Glyph(int codePoint, double widthHundredths, List<double[]> strokes) {
    /** The same letter with another's strokes added, moved by (dx, dy). */
    Glyph with(Glyph mark, int newCodePoint, double dx, double dy) {
        var all = new ArrayList<>(strokes);
        for (var stroke : mark.strokes) {
            var moved = stroke.clone();
            for (int i = 0; i < moved.length; i += 2) {
                moved[i] += dx;
                moved[i + 1] += dy;
            }
            all.add(moved);
        }
        return new Glyph(newCodePoint, widthHundredths, all);
    }
}
