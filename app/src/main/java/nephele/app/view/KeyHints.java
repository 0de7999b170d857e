package nephele.app.view;

import java.util.List;
import nephele.app.play.hud.HudPalette;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The key hints in lines along the lower edge, and a message in the upper left corner. Lengths are in points. */
final class KeyHints {
    private static final double EM = 13;
    private static final double LINE = 19;
    private static final double PADDING = 12;
    private static final double GAP = 15;
    private static final double KEY_GAP = 6;

    private static final List<Hint> ALL = List.of(
            new Hint("W A S D", Phrase.VIEWER_MOVE),
            new Hint("Shift", Phrase.VIEWER_FASTER),
            new Hint("← → ↑ ↓", Phrase.VIEWER_TURN),
            new Hint("F1", Phrase.VIEWER_WIREFRAME),
            new Hint("F2", Phrase.VIEWER_AXES),
            new Hint("F3", Phrase.VIEWER_SHADING),
            new Hint("1 2 3 4", Phrase.VIEWER_TERMS),
            new Hint("Space", Phrase.VIEWER_PAUSE),
            new Hint("R", Phrase.VIEWER_HOME),
            new Hint("F11", Phrase.VIEWER_FULL_SCREEN),
            new Hint("F12", Phrase.VIEWER_PICTURE),
            new Hint("H", Phrase.VIEWER_KEYS),
            new Hint("Escape", Phrase.VIEWER_LEAVE));

    private final OverlayCanvas canvas;
    private final Language language;

    KeyHints(OverlayCanvas canvas, Language language) {
        this.canvas = canvas;
        this.language = language;
    }

    private record Hint(String key, Phrase phrase) {}

    private String key(Hint hint) {
        return hint.key.contains(" ") || hint.key.equals("Shift") ? hint.key : Phrase.ofKey(hint.key, language);
    }

    private double width(Hint hint) {
        return canvas.width(EM, key(hint)) + KEY_GAP + canvas.width(EM, hint.phrase.in(language));
    }

    /** @param opacity 1 while the hints are shown, less while they fade, 0 for none */
    void draw(double width, double height, double opacity) {
        if (opacity <= 0) {
            return;
        }
        int lines = 1 + walk(width, (hint, x, line) -> {});
        double top = height - 2 * PADDING - lines * LINE;
        canvas.rectangle(0, top, width, height - top, HudPalette.VEIL.withAlpha(0.55 * opacity));
        walk(width, (hint, x, line) -> {
            double baseline = top + PADDING + (line + 0.7) * LINE;
            double after = canvas.text(x, baseline, EM, HudPalette.ACCENT.withAlpha(opacity), key(hint));
            canvas.text(after + KEY_GAP, baseline, EM, HudPalette.INK.withAlpha(opacity), hint.phrase.in(language));
        });
    }

    /**
     * Draws a message in the upper left corner; one that is wider than the picture is smaller.
     *
     * @param room the picture's width
     */
    void say(double room, String message) {
        double most = room - 4 * PADDING;
        double whole = canvas.width(EM, message);
        double em = EM * Math.min(1, most / whole);
        double width = Math.min(whole, most) + 2 * PADDING;
        canvas.rectangle(PADDING, PADDING, width, LINE + PADDING, HudPalette.VEIL.withAlpha(0.55));
        canvas.text(2 * PADDING, PADDING + LINE, em, HudPalette.INK, message);
    }

    private interface Placing {
        void at(Hint hint, double x, int line);
    }

    /** Lays out the hints like the words of a text. Returns the last line's number. */
    private int walk(double width, Placing placing) {
        double x = PADDING;
        int line = 0;
        for (Hint hint : ALL) {
            double hintWidth = width(hint);
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
