package nephele.app.play.hud;

import java.util.List;
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
    private static final double HANDLE_FRACTION = 0.34;
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
    private final Box room;
    private final HudContent.Comparison comparison;
    private final double scale;
    private final double x;

    /**
     * A low window has smaller labels, as it has smaller messages.
     *
     * @param room where labels and handle may be
     */
    WipeLine(OverlayCanvas canvas, Area area, Box room, HudContent.Comparison comparison) {
        this.canvas = canvas;
        this.area = area;
        this.room = room;
        this.comparison = comparison;
        scale = Math.max(LEAST_SCALE, Math.min(1, area.height() / FULL_SIZE_HEIGHT));
        x = comparison.wipe().fraction() * area.width();
    }

    /** @param sight the crosshair, for which the line has a gap; {@code null} for none */
    void drawLine(HudContent.Sight sight) {
        double gap = sight == null ? 0 : GAP;
        line(0, area.centreY() - gap);
        line(area.centreY() + gap, area.height());
    }

    private void line(double top, double bottom) {
        canvas.rectangle(x - LINE / 2 - EDGE, top, LINE + 2 * EDGE, bottom - top, HudPalette.SHADOW);
        canvas.rectangle(x - LINE / 2, top, LINE, bottom - top, HudPalette.INK);
    }

    Box handle() {
        double width = scale * HANDLE_WIDTH + 2 * EDGE;
        double height = scale * HANDLE_HEIGHT + 2 * EDGE;
        double left = Math.max(room.left(), Math.min(x - width / 2, room.right() - width));
        double top = HANDLE_FRACTION * area.height() - height / 2;
        return new Box(left, top, left + width, top + height);
    }

    void drawHandle() {
        Box box = handle();
        canvas.rectangle(box.left(), box.top(), box.width(), box.height(), HudPalette.INK);
        double height = box.height() - 2 * EDGE;
        canvas.rectangle(box.left() + EDGE, box.top() + EDGE, box.width() - 2 * EDGE, height, HudPalette.HANDLE);
        double em = scale * ARROW_EM;
        double baseline = box.top() + box.height() / 2 + 0.35 * em;
        double left = box.left() + box.width() / 2 - canvas.width(em, ARROWS) / 2;
        canvas.text(left, baseline, em, HudPalette.ACCENT, ARROWS);
    }

    /** Returns the boxes of the labels: they flank the line; at an edge of the room they stay side by side in it. */
    List<Box> labels() {
        double beside = scale * BESIDE;
        double em = labelEm();
        double leftWidth = plateWidth(em, comparison.left());
        double rightWidth = plateWidth(em, comparison.right());
        double least = room.left() + leftWidth + 2 * beside;
        double most = room.right() - rightWidth - 2 * beside;
        double middle = Math.max(least, Math.min(x, most));
        double top = scale * TOP;
        double bottom = top + height(em);
        return List.of(
                new Box(middle - beside - leftWidth, top, middle - beside, bottom),
                new Box(middle + beside, top, middle + beside + rightWidth, bottom));
    }

    /** Labels that are wider than the room are smaller. */
    private double labelEm() {
        double em = scale * EM;
        double wanted = plateWidth(em, comparison.left()) + plateWidth(em, comparison.right()) + 4 * scale * BESIDE;
        return em * Math.min(1, room.width() / wanted);
    }

    void drawLabels() {
        List<Box> boxes = labels();
        plate(boxes.get(0), labelEm(), comparison.left());
        plate(boxes.get(1), labelEm(), comparison.right());
    }

    /** Returns the box of the difference; one that is wider than the room is smaller. */
    Box difference() {
        double em = differenceEm();
        double width = plateWidth(em, comparison.difference());
        double left = room.leftOf(width, area.centreX());
        double bottom = area.height() - scale * BOTTOM;
        return new Box(left, bottom - height(em), left + width, bottom);
    }

    private double differenceEm() {
        double em = scale * SMALL_EM;
        double wanted = plateWidth(em, comparison.difference()) + 2 * scale * BESIDE;
        return em * Math.min(1, room.width() / wanted);
    }

    void drawDifference() {
        plate(difference(), differenceEm(), comparison.difference());
    }

    private double plateWidth(double em, String text) {
        return canvas.width(em, text) + 2 * padding(em);
    }

    private static double padding(double em) {
        return PADDING / EM * em;
    }

    private static double height(double em) {
        return em + padding(em);
    }

    private void plate(Box box, double em, String text) {
        canvas.rectangle(box.left(), box.top(), box.width(), box.height(), HudPalette.PANEL);
        double baseline = box.top() + padding(em) / 2 + 0.82 * em;
        canvas.text(box.left() + padding(em), baseline, em, HudPalette.INK, text);
    }
}
