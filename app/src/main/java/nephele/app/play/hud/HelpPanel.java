package nephele.app.play.hud;

import nephele.app.window.Control;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The F1 page: every key and what it does. */
final class HelpPanel {
    private static final double WIDTH = 560;
    private static final double PADDING = 32;
    private static final double TITLE_EM = 32;
    private static final double ROW_HEIGHT = 29;
    private static final double EM = 18;
    private static final double KEY_COLUMN = 112;

    private HelpPanel() {}

    static void draw(OverlayCanvas canvas, Area area) {
        int rows = Control.values().length + 1;
        double height = 2 * PADDING + 2 * TITLE_EM + rows * ROW_HEIGHT;
        double left = Math.rint(area.centreX() - WIDTH / 2);
        double top = Math.max(0, Math.rint(area.centreY() - height / 2));
        canvas.rectangle(left, top, WIDTH, height, Palette.PANEL);
        canvas.rectangle(left, top, WIDTH, 3, Palette.ACCENT);
        canvas.text(left + PADDING, top + PADDING + 0.7 * TITLE_EM, TITLE_EM, Palette.INK, "Keys");
        double baseline = top + PADDING + 2 * TITLE_EM + 0.5 * ROW_HEIGHT;
        row(canvas, left + PADDING, baseline, "Mouse", "look around");
        for (var control : Control.values()) {
            baseline += ROW_HEIGHT;
            row(canvas, left + PADDING, baseline, control.keys(), control.meaning());
        }
    }

    private static void row(OverlayCanvas canvas, double x, double baseline, String keys, String meaning) {
        canvas.text(x, baseline, EM, Palette.ACCENT, keys);
        canvas.text(x + KEY_COLUMN, baseline, EM, Palette.INK, meaning);
    }
}
