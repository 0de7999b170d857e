package nephele.app.view;

import java.util.List;
import nephele.app.play.hud.HudPalette;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The key hints in lines along the lower edge, and a message in the upper left corner. Lengths are in points. */
final class KeyHints {
    private static final double EM = 13;
    private static final double LINE = 19;
    private static final double PADDING = 12;
    private static final double GAP = 15;
    private static final double KEY_GAP = 6;

    private static final List<Hint> ALL = List.of(
            new Hint("W A S D", "move"),
            new Hint("Shift", "faster"),
            new Hint("← → ↑ ↓", "or drag: turn"),
            new Hint("F1", "wireframe"),
            new Hint("F2", "axes"),
            new Hint("F3", "shading"),
            new Hint("1 2 3 4", "light terms"),
            new Hint("Space", "pause"),
            new Hint("R", "start again"),
            new Hint("F11", "full screen"),
            new Hint("F12", "picture"),
            new Hint("H", "keys"),
            new Hint("Esc", "leave"));

    private KeyHints() {}

    private record Hint(String keys, String meaning) {
        double width(OverlayCanvas canvas) {
            return canvas.width(EM, keys) + KEY_GAP + canvas.width(EM, meaning);
        }
    }

    /** @param opacity 1 while the hints are shown, less while they fade, 0 for none */
    static void draw(OverlayCanvas canvas, double width, double height, double opacity) {
        if (opacity <= 0) {
            return;
        }
        int lines = 1 + walk(canvas, width, (hint, x, line) -> {});
        double top = height - 2 * PADDING - lines * LINE;
        canvas.rectangle(0, top, width, height - top, HudPalette.VEIL.withAlpha(0.55 * opacity));
        walk(canvas, width, (hint, x, line) -> {
            double baseline = top + PADDING + (line + 0.7) * LINE;
            double after = canvas.text(x, baseline, EM, HudPalette.ACCENT.withAlpha(opacity), hint.keys);
            canvas.text(after + KEY_GAP, baseline, EM, HudPalette.INK.withAlpha(opacity), hint.meaning);
        });
    }

    /** Draws a message in the upper left corner. */
    static void say(OverlayCanvas canvas, String message) {
        double width = canvas.width(EM, message) + 2 * PADDING;
        canvas.rectangle(PADDING, PADDING, width, LINE + PADDING, HudPalette.VEIL.withAlpha(0.55));
        canvas.text(2 * PADDING, PADDING + LINE, EM, HudPalette.INK, message);
    }

    private interface Placing {
        void at(Hint hint, double x, int line);
    }

    /** Lays out the hints like the words of a text. Returns the last line's number. */
    private static int walk(OverlayCanvas canvas, double width, Placing placing) {
        double x = PADDING;
        int line = 0;
        for (Hint hint : ALL) {
            double hintWidth = hint.width(canvas);
            if (x > PADDING && x + hintWidth > width - PADDING) {
                x = PADDING;
                line++;
            }
            placing.at(hint, x, line);
            x += hintWidth + GAP;
        }
        return line;
    }
}
