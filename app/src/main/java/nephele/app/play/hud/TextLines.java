package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * Lines of text, broken to a width.
 *
 * @param em the size of their letters
 */
record TextLines(double em, List<String> lines) {
    private static final String CUT = " …";

    /** Returns lines broken at spaces, and inside of words that are wider than a line (paths). */
    static List<String> broken(OverlayCanvas canvas, double em, double width, String text) {
        List<String> lines = new ArrayList<>();
        double space = canvas.width(em, " ");
        String line = "";
        double used = 0;
        for (String word : text.split(" ")) {
            double wordWidth = canvas.width(em, word);
            if (line.isEmpty() ? wordWidth <= width : used + space + wordWidth <= width) {
                used = line.isEmpty() ? wordWidth : used + space + wordWidth;
                line = line.isEmpty() ? word : line + " " + word;
                continue;
            }
            if (!line.isEmpty()) {
                lines.add(line);
            }
            line = word;
            used = wordWidth;
            while (used > width) {
                int fitting = fitting(canvas, em, width, line);
                lines.add(line.substring(0, fitting));
                line = line.substring(fitting);
                used = canvas.width(em, line);
            }
        }
        lines.add(line);
        return lines;
    }

    /** Returns the first lines; if there are more, the end of the last one is cut and says so. */
    static List<String> first(OverlayCanvas canvas, double em, double width, List<String> lines, int most) {
        if (lines.size() <= most) {
            return lines;
        }
        List<String> kept = new ArrayList<>(lines.subList(0, most));
        String last = kept.get(most - 1);
        while (!last.isEmpty() && canvas.width(em, last + CUT) > width) {
            last = last.substring(0, last.length() - 1);
        }
        kept.set(most - 1, last + CUT);
        return kept;
    }

    /** Returns the number of letters that fit, at least one. */
    private static int fitting(OverlayCanvas canvas, double em, double width, String word) {
        int letters = 0;
        double used = 0;
        while (letters < word.length() && (letters == 0 || used <= width)) {
            used += canvas.width(em, word.substring(letters, letters + 1));
            letters++;
        }
        return used <= width || letters == 1 ? letters : letters - 1;
    }
}
