package nephele.app.view;

import java.util.ArrayList;
import java.util.List;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.HudPalette;
import nephele.app.settings.Phrase;
import nephele.app.window.GameWindow;
import nephele.engine.level.Language;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayPass;

/**
 * The text over the picture, lengths in points. The key hints are shown at the start and on demand; messages are shown for three seconds.
 */
final class ViewerOverlay implements AutoCloseable {
    private static final double SHOWN_SECONDS = 10;
    private static final double FADE_SECONDS = 1;
    private static final double MESSAGE_SECONDS = 3;
    private static final int FADE_STEPS = 16;

    private static final double EM = 13;
    private static final double LINE = 19;
    private static final double PADDING = 12;
    private static final double GAP = 15;
    private static final double KEY_GAP = 6;

    private static final List<Hint> HINTS = List.of(
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

    private final FontAtlas letters = new FontAtlas();
    private final OverlayCanvas canvas = new OverlayCanvas(letters);
    private final OverlayPass pass;
    private final Language language;
    private double hintSeconds = SHOWN_SECONDS + FADE_SECONDS;
    private double messageSeconds;
    private String message;
    private Content drawn;

    /** The values that the canvas depends on. */
    private record Content(String message, int opacity, int width, int height, double scale) {}

    ViewerOverlay(GlContext gl, Language language) {
        this.language = language;
        pass = new OverlayPass(gl, letters);
    }

    void say(String words) {
        message = words;
        messageSeconds = MESSAGE_SECONDS;
    }

    /** Shows or hides the key hints; once requested they stay until hidden. */
    void toggleKeys() {
        hintSeconds = hintSeconds > 0 ? 0 : Double.POSITIVE_INFINITY;
    }

    void advance(double seconds) {
        hintSeconds = Math.max(0, hintSeconds - seconds);
        messageSeconds -= seconds;
        if (messageSeconds <= 0) {
            message = null;
        }
    }

    void draw(GameWindow window, RenderTarget target) {
        int opacity = (int) Math.ceil(FADE_STEPS * Math.min(1, hintSeconds / FADE_SECONDS));
        double scale = Area.pixelsPerPoint(target.width(), target.height(), window.scale());
        var content = new Content(message, opacity, target.width(), target.height(), scale);
        if (!content.equals(drawn)) {
            drawn = content;
            canvas.begin(content.scale);
            fill(content);
        }
        pass.draw(canvas, target);
    }

    private void fill(Content content) {
        double width = content.width / content.scale;
        double height = content.height / content.scale;
        drawHints(width, height, (double) content.opacity / FADE_STEPS);
        if (content.message != null) {
            drawMessage(width, content.message);
        }
    }

    @Override
    public void close() {
        pass.close();
    }

    private record Hint(String key, Phrase phrase) {}

    private String key(Hint hint) {
        return hint.key.contains(" ") || hint.key.equals("Shift") ? hint.key : Phrase.ofKey(hint.key, language);
    }

    private double width(Hint hint) {
        return canvas.width(EM, key(hint)) + KEY_GAP + canvas.width(EM, hint.phrase.in(language));
    }

    /**
     * Draws the key hints in lines along the lower edge.
     *
     * @param opacity 1 while the hints are shown, less while they fade, 0 for none
     */
    private void drawHints(double width, double height, double opacity) {
        if (opacity <= 0) {
            return;
        }
        List<List<Hint>> lines = lines(width);
        double top = height - 2 * PADDING - lines.size() * LINE;
        canvas.rectangle(0, top, width, height - top, HudPalette.VEIL.withAlpha(0.55 * opacity));
        for (int line = 0; line < lines.size(); line++) {
            double x = PADDING;
            double baseline = top + PADDING + (line + 0.7) * LINE;
            for (Hint hint : lines.get(line)) {
                double after = canvas.text(x, baseline, EM, HudPalette.ACCENT.withAlpha(opacity), key(hint));
                canvas.text(after + KEY_GAP, baseline, EM, HudPalette.INK.withAlpha(opacity), hint.phrase.in(language));
                x += width(hint) + GAP;
            }
        }
    }

    /**
     * Draws a message in the upper left corner; one that is wider than the picture is smaller.
     *
     * @param room the picture's width
     */
    private void drawMessage(double room, String message) {
        double most = room - 4 * PADDING;
        double whole = canvas.width(EM, message);
        double em = EM * Math.min(1, most / whole);
        double width = Math.min(whole, most) + 2 * PADDING;
        canvas.rectangle(PADDING, PADDING, width, LINE + PADDING, HudPalette.VEIL.withAlpha(0.55));
        canvas.text(2 * PADDING, PADDING + LINE, em, HudPalette.INK, message);
    }

    /** Breaks the hints into lines like the words of a text. */
    private List<List<Hint>> lines(double width) {
        List<List<Hint>> lines = new ArrayList<>(List.of(new ArrayList<>()));
        double x = PADDING;
        for (Hint hint : HINTS) {
            double hintWidth = width(hint);
            if (x > PADDING && x + hintWidth > width - PADDING) {
                lines.add(new ArrayList<>());
                x = PADDING;
            }
            lines.get(lines.size() - 1).add(hint);
            x += hintWidth + GAP;
        }
        return lines;
    }
}
