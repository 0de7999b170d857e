package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** Breaks text into lines of a width. */
final class TextLines {
    private TextLines() {}

    /** Returns lines broken at spaces, and inside of words that are wider than a line (paths). */
    static List<String> of(OverlayCanvas canvas, double em, double width, String text) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : text.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (canvas.width(em, longer) <= width) {
                line = longer;
                continue;
            }
            if (!line.isEmpty()) {
                lines.add(line);
            }
            line = word;
            while (canvas.width(em, line) > width) {
                int fitting = fitting(canvas, em, width, line);
                lines.add(line.substring(0, fitting));
                line = line.substring(fitting);
            }
        }
        lines.add(line);
        return lines;
    }

    /** Returns the number of letters that fit, at least one. */
    private static int fitting(OverlayCanvas canvas, double em, double width, String word) {
        int letters = 1;
        while (letters < word.length() && canvas.width(em, word.substring(0, letters + 1)) <= width) {
            letters++;
        }
        return letters;
    }
}
