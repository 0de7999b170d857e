package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The latest message, at the lower edge. Lengths are in points. */
final class MessageBar {
    private static final double EM = 19;
    private static final double PADDING = 14;
    private static final double BOTTOM = 48;

    private MessageBar() {}

    /** Returns the upper edge of every message. */
    static double top(Area area) {
        return area.height() - BOTTOM - EM - 2 * PADDING;
    }

    static void draw(OverlayCanvas canvas, Area area, String message) {
        double scale = Math.min(1, area.width() / (canvas.width(EM, message) + 2 * PADDING));
        double width = scale * (canvas.width(EM, message) + 2 * PADDING);
        double left = Math.max(0, Math.rint(area.centreX() - width / 2));
        double height = EM + 2 * PADDING;
        canvas.rectangle(left, top(area), width, height, HudPalette.PANEL);
        double baseline = top(area) + height / 2 + 0.35 * EM;
        canvas.text(left + scale * PADDING, baseline, scale * EM, HudPalette.INK, message);
    }
}
