package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** A line below the crosshair that names the key of a possible action. Lengths are in points. */
final class PromptLine {
    private static final double EM = 20;
    private static final double PADDING = 10;
    private static final double BELOW_CENTRE_FRACTION = 0.16;
    private static final double FULL_SIZE_HEIGHT = 540;
    private static final double LEAST_SCALE = 0.65;

    private final String prompt;
    private final double scale;
    private final Box box;

    /** @param room where it may be; a longer line is smaller */
    PromptLine(OverlayCanvas canvas, Area area, Box room, String prompt) {
        this.prompt = prompt;
        double full = canvas.width(EM, prompt) + 2 * PADDING;
        double low = Math.max(LEAST_SCALE, Math.min(1, area.height() / FULL_SIZE_HEIGHT));
        scale = Math.min(low, room.width() / full);
        double left = room.leftOf(scale * full, area.centreX());
        double top = Math.rint(area.centreY() + BELOW_CENTRE_FRACTION * area.height());
        box = new Box(left, top, left + scale * full, top + scale * (EM + 2 * PADDING));
    }

    Box box() {
        return box;
    }

    void draw(OverlayCanvas canvas) {
        canvas.rectangle(box.left(), box.top(), box.width(), box.height(), HudPalette.PANEL);
        double baseline = box.top() + scale * (PADDING + 0.85 * EM);
        canvas.text(box.left() + scale * PADDING, baseline, scale * EM, HudPalette.INK, prompt);
    }
}
