package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * The line between two compared techniques with a handle, their labels on both sides at the top, and their difference at
 * the lower edge. Lengths are in points.
 */
final class WipeLine {
    private static final double LINE = 2;
    private static final double EDGE = 1;
    private static final double HANDLE_WIDTH = 26;
    private static final double HANDLE_HEIGHT = 34;
    private static final double ARROW_EM = 17;
    /** The handle's place: above the crosshair. */
    private static final double HANDLE_SHARE = 0.34;
    /** Half the height of the gap for the crosshair. */
    private static final double GAP = 26;

    private static final double TOP = 12;
    private static final double EM = 18;
    private static final double SMALL_EM = 16;
    private static final double PADDING = 10;
    private static final double BESIDE = 10;
    private static final double BOTTOM = 10;

    private final OverlayCanvas canvas;
    private final Area area;
    private final HudContent.Comparison comparison;
    private final double x;

    WipeLine(OverlayCanvas canvas, Area area, HudContent.Comparison comparison) {
        this.canvas = canvas;
        this.area = area;
        this.comparison = comparison;
        x = comparison.wipe().share() * area.width();
    }

    void draw() {
        line(0, area.centreY() - GAP);
        line(area.centreY() + GAP, area.height());
        handle();
        double leftWidth = plateWidth(EM, comparison.left());
        double rightWidth = plateWidth(EM, comparison.right());
        plate(clamped(x - BESIDE - leftWidth, leftWidth, -1), TOP, EM, comparison.left());
        plate(clamped(x + BESIDE, rightWidth, 1), TOP, EM, comparison.right());
        if (!comparison.difference().isEmpty()) {
            double em =
                    Math.min(SMALL_EM, SMALL_EM * area.width() / (plateWidth(SMALL_EM, comparison.difference()) + 1));
            double width = plateWidth(em, comparison.difference());
            double top = area.height() - BOTTOM - height(em);
            plate((area.width() - width) / 2, top, em, comparison.difference());
        }
    }

    private void line(double top, double bottom) {
        canvas.rectangle(x - LINE / 2 - EDGE, top, LINE + 2 * EDGE, bottom - top, HudPalette.SHADOW);
        canvas.rectangle(x - LINE / 2, top, LINE, bottom - top, HudPalette.INK);
    }

    private void handle() {
        double top = HANDLE_SHARE * area.height() - HANDLE_HEIGHT / 2;
        double left = x - HANDLE_WIDTH / 2;
        canvas.rectangle(left - EDGE, top - EDGE, HANDLE_WIDTH + 2 * EDGE, HANDLE_HEIGHT + 2 * EDGE, HudPalette.INK);
        canvas.rectangle(left, top, HANDLE_WIDTH, HANDLE_HEIGHT, HudPalette.HANDLE);
        double baseline = top + HANDLE_HEIGHT / 2 + 0.35 * ARROW_EM;
        double width = canvas.width(ARROW_EM, "‹");
        canvas.text(x - 3 - width, baseline, ARROW_EM, HudPalette.ACCENT, "‹");
        canvas.text(x + 3, baseline, ARROW_EM, HudPalette.ACCENT, "›");
    }

    /** Returns the left edge of a plate that stays in the picture; {@code side} is −1 for the left label, 1 for the right. */
    private double clamped(double left, double width, int side) {
        double most = area.width() - BESIDE - width;
        double kept = Math.max(BESIDE, Math.min(left, most));
        double other = plateWidth(EM, side < 0 ? comparison.right() : comparison.left());
        // At an edge of the picture both labels stay side by side, in their order.
        return side < 0 ? Math.min(kept, most - 2 * BESIDE - other) : Math.max(kept, 3 * BESIDE + other);
    }

    private double plateWidth(double em, String text) {
        return canvas.width(em, text) + 2 * PADDING;
    }

    private static double height(double em) {
        return em + PADDING;
    }

    private void plate(double left, double top, double em, String text) {
        canvas.rectangle(left, top, plateWidth(em, text), height(em), HudPalette.PANEL);
        canvas.text(left + PADDING, top + PADDING / 2 + 0.82 * em, em, HudPalette.INK, text);
    }
}
