package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The latest message, at the lower edge. Lengths are in points. */
final class MessageBar {
    private static final double EM = 19;
    private static final double PADDING = 14;
    private static final double BOTTOM = 48;

    private MessageBar() {}

    static void draw(OverlayCanvas canvas, Area area, String message) {
        double width = canvas.width(EM, message) + 2 * PADDING;
        double left = Math.max(0, Math.rint(area.centreX() - width / 2));
        double height = EM + 2 * PADDING;
        double top = area.height() - BOTTOM - height;
        canvas.rectangle(left, top, width, height, HudPalette.PANEL);
        canvas.text(left + PADDING, top + height / 2 + 0.35 * EM, EM, HudPalette.INK, message);
    }
}
