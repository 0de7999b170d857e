package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** A line below the crosshair that names the key of a possible action. Lengths are in points. */
final class PromptLine {
    private static final double EM = 20;
    private static final double PADDING = 10;
    private static final double BELOW_CENTRE_SHARE = 0.16;

    private PromptLine() {}

    static void draw(OverlayCanvas canvas, Area area, String prompt) {
        double width = canvas.width(EM, prompt) + 2 * PADDING;
        double left = Math.rint(area.centreX() - width / 2);
        double top = Math.rint(area.centreY() + BELOW_CENTRE_SHARE * area.height());
        canvas.rectangle(left, top, width, EM + 2 * PADDING, HudPalette.PANEL);
        canvas.text(left + PADDING, top + PADDING + 0.85 * EM, EM, HudPalette.INK, prompt);
    }
}
