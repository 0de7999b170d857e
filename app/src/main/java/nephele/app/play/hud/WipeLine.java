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
    private static final String ARROWS = "‹ ›";
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

    private static final double FULL_SIZE_HEIGHT = 540;
    private static final double LEAST_SCALE = 0.65;

    private final OverlayCanvas canvas;
    private final Area area;
    private final HudContent.Comparison comparison;
    private final double scale;
    private final double x;

    /** A low window has smaller labels, as it has smaller messages. */
    WipeLine(OverlayCanvas canvas, Area area, HudContent.Comparison comparison) {
        this.canvas = canvas;
        this.area = area;
        this.comparison = comparison;
        scale = Math.max(LEAST_SCALE, Math.min(1, area.height() / FULL_SIZE_HEIGHT));
        x = comparison.wipe().share() * area.width();
    }

    /** @param sight the crosshair, for which the line has a gap; {@code null} for none */
    void draw(HudContent.Sight sight) {
        double gap = sight == null ? 0 : GAP;
        line(0, area.centreY() - gap);
        line(area.centreY() + gap, area.height());
        handle();
        labels();
        if (!comparison.difference().isEmpty()) {
            double wanted = plateWidth(SMALL_EM, comparison.difference());
            double em = SMALL_EM * Math.min(1, area.width() / scale / (wanted + 2 * BESIDE));
            double left = (area.width() - scale * plateWidth(em, comparison.difference())) / 2;
            plate(left, area.height() - scale * (BOTTOM + height(em)), em, comparison.difference());
        }
    }

    private void line(double top, double bottom) {
        canvas.rectangle(x - LINE / 2 - EDGE, top, LINE + 2 * EDGE, bottom - top, HudPalette.SHADOW);
        canvas.rectangle(x - LINE / 2, top, LINE, bottom - top, HudPalette.INK);
    }

    private void handle() {
        double width = scale * HANDLE_WIDTH;
        double height = scale * HANDLE_HEIGHT;
        double top = HANDLE_SHARE * area.height() - height / 2;
        double centre = Math.max(width / 2 + EDGE, Math.min(x, area.width() - width / 2 - EDGE));
        canvas.rectangle(centre - width / 2 - EDGE, top - EDGE, width + 2 * EDGE, height + 2 * EDGE, HudPalette.INK);
        canvas.rectangle(centre - width / 2, top, width, height, HudPalette.HANDLE);
        double em = scale * ARROW_EM;
        double baseline = top + height / 2 + 0.35 * em;
        canvas.text(centre - canvas.width(em, ARROWS) / 2, baseline, em, HudPalette.ACCENT, ARROWS);
    }

    /** The labels flank the line; at an edge of the picture they stay side by side in it. */
    private void labels() {
        double leftWidth = scale * plateWidth(EM, comparison.left());
        double rightWidth = scale * plateWidth(EM, comparison.right());
        double beside = scale * BESIDE;
        double least = leftWidth + 2 * beside;
        double most = area.width() - rightWidth - 2 * beside;
        double middle = Math.max(least, Math.min(x, most));
        plate(middle - beside - leftWidth, scale * TOP, EM, comparison.left());
        plate(middle + beside, scale * TOP, EM, comparison.right());
    }

    /** Returns the width of a plate before it is scaled. */
    private double plateWidth(double em, String text) {
        return canvas.width(em, text) + 2 * PADDING;
    }

    private static double height(double em) {
        return em + PADDING;
    }

    private void plate(double left, double top, double em, String text) {
        canvas.rectangle(left, top, scale * plateWidth(em, text), scale * height(em), HudPalette.PANEL);
        double baseline = top + scale * (PADDING / 2 + 0.82 * em);
        canvas.text(left + scale * PADDING, baseline, scale * em, HudPalette.INK, text);
    }
}
