package nephele.app.play.hud;

import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayColour;

/**
 * The menu in the middle of the picture. Lengths are in points. A low window shrinks the panel, down to a scale at
 * which text is still legible; then entries scroll, so that the selected one is visible.
 */
public final class MenuPanel {
    private static final double WIDTH = 440;
    private static final double PADDING = 32;
    private static final double TITLE_EM = 40;
    private static final double TITLE_HEIGHT = 72;
    private static final double LINE_EM = 19;
    private static final double LINE_HEIGHT = 28;
    private static final double ROW_HEIGHT = 44;
    private static final double ROW_EM = 22;
    private static final double FOOT_HEIGHT = 34;
    private static final double FOOT_EM = 15;
    private static final double FOOT_LINE_EMS = 1.27;
    private static final int FOOT_LINES = 2;
    private static final double LEAST_SCALE = 0.62;
    private static final double GAP = 14;
    private static final double PICTURE_WIDTH = 384;
    private static final double BESIDE = 16;

    private final Menu menu;
    private final Area area;
    private final double blockWidth;
    private final double scale;
    private final int visibleRows;
    private final int firstVisible;

    public MenuPanel(Menu menu, Area area) {
        this.menu = menu;
        this.area = area;
        int rows = menu.entries().size();
        blockWidth = WIDTH + (menu.hasPictures() ? BESIDE + PICTURE_WIDTH : 0);
        double wanted = Math.min(area.height() / height(rows), area.width() / (blockWidth + 2 * BESIDE));
        scale = Math.max(LEAST_SCALE, Math.min(1, wanted));
        int fitting = (int) Math.floor((area.height() / scale - height(0)) / ROW_HEIGHT);
        visibleRows = Math.max(1, Math.min(rows, fitting));
        firstVisible = Math.max(0, Math.min(menu.selected() - visibleRows / 2, rows - visibleRows));
    }

    private double height(int rows) {
        return PADDING + TITLE_HEIGHT + linesHeight() + rows * ROW_HEIGHT + FOOT_HEIGHT + PADDING;
    }

    private double linesHeight() {
        return menu.lines().isEmpty() ? 0 : menu.lines().size() * LINE_HEIGHT + GAP;
    }

    /** Returns the row under a point, or −1. */
    public int rowAt(double x, double y) {
        boolean beside = x < left() || x > left() + scale * WIDTH;
        int row = (int) Math.floor((y - firstRow()) / (scale * ROW_HEIGHT));
        return beside || row < 0 || row >= visibleRows ? -1 : firstVisible + row;
    }

    /** Draws the menu with its own foot. */
    void draw(OverlayCanvas canvas) {
        draw(canvas, menu.foot(), HudPalette.QUIET_INK);
    }

    /** @param foot the text below the entries; one of more than two lines is smaller */
    void draw(OverlayCanvas canvas, String foot, OverlayColour ink) {
        canvas.rectangle(0, 0, area.width(), area.height(), HudPalette.VEIL);
        canvas.rectangle(left(), top(), scale * WIDTH, scale * height(visibleRows), HudPalette.PANEL);
        canvas.rectangle(left(), top(), scale * WIDTH, 3, HudPalette.ACCENT);
        double x = left() + scale * PADDING;
        fitted(canvas, x, top() + scale * (PADDING + 0.7 * TITLE_EM), scale * TITLE_EM, menu.title());
        double y = top() + scale * (PADDING + TITLE_HEIGHT);
        for (String line : menu.lines()) {
            fitted(canvas, x, y, scale * LINE_EM, line);
            y += scale * LINE_HEIGHT;
        }
        for (int row = 0; row < visibleRows; row++) {
            drawRow(canvas, firstVisible + row, firstRow() + row * scale * ROW_HEIGHT);
        }
        drawFoot(canvas, x, foot, ink);
        drawPicture(canvas);
        drawArrows(canvas);
    }

    private void drawPicture(OverlayCanvas canvas) {
        Picture picture = menu.picture();
        if (picture != null) {
            double x = left() + scale * (WIDTH + BESIDE);
            double width = scale * PICTURE_WIDTH;
            double height = width * picture.height() / picture.width();
            canvas.rectangle(x, top(), width, 3, HudPalette.ACCENT);
            canvas.picture(x, top() + 3, width, height, picture);
        }
    }

    private void drawFoot(OverlayCanvas canvas, double x, String foot, OverlayColour ink) {
        double em = FOOT_EM;
        List<String> lines = TextLines.of(canvas, em, WIDTH - 2 * PADDING, foot);
        if (lines.size() > FOOT_LINES) {
            em = FOOT_EM * FOOT_LINES / (FOOT_LINES + 1);
            lines = TextLines.of(canvas, em, WIDTH - 2 * PADDING, foot);
        }
        double baseline = firstRow() + scale * (visibleRows * ROW_HEIGHT + FOOT_HEIGHT);
        for (String line : lines) {
            canvas.text(x, baseline, scale * em, ink, line);
            baseline += scale * em * FOOT_LINE_EMS;
        }
    }

    /** Draws a line, smaller if it is wider than the panel. */
    private void fitted(OverlayCanvas canvas, double x, double baseline, double em, String title) {
        double room = scale * (WIDTH - 2 * PADDING);
        double width = canvas.width(em, title);
        canvas.text(x, baseline, Math.min(em, em * room / width), HudPalette.INK, title);
    }

    /** Draws a mark at the end of a list that continues. */
    private void drawArrows(OverlayCanvas canvas) {
        double x = left() + scale * (WIDTH - PADDING);
        if (firstVisible > 0) {
            canvas.text(x, firstRow() + scale * 4, scale * FOOT_EM, HudPalette.ACCENT, "↑");
        }
        if (firstVisible + visibleRows < menu.entries().size()) {
            double bottom = firstRow() + scale * visibleRows * ROW_HEIGHT;
            canvas.text(x, bottom + scale * 12, scale * FOOT_EM, HudPalette.ACCENT, "↓");
        }
    }

    private void drawRow(OverlayCanvas canvas, int row, double y) {
        boolean selected = row == menu.selected();
        if (selected) {
            canvas.rectangle(left(), y, scale * WIDTH, scale * ROW_HEIGHT, HudPalette.SELECTED);
            canvas.rectangle(left(), y, 4, scale * ROW_HEIGHT, HudPalette.ACCENT);
        }
        double em = scale * ROW_EM;
        double baseline = y + scale * ROW_HEIGHT / 2 + 0.35 * em;
        var entry = menu.entries().get(row);
        var ink = selected ? HudPalette.INK : HudPalette.QUIET_INK;
        double end = canvas.text(left() + scale * PADDING, baseline, em, ink, entry.label());
        if (!entry.value().isEmpty()) {
            double valueEm = 0.85 * em;
            double right = left() + scale * (WIDTH - PADDING);
            double room = right - end - scale * GAP;
            double width = canvas.width(valueEm, entry.value());
            double fitting = Math.min(valueEm, valueEm * room / width);
            canvas.text(
                    right - Math.min(width, room),
                    baseline,
                    fitting,
                    selected ? HudPalette.ACCENT : ink,
                    entry.value());
        }
    }

    /** Returns the panel's lower edge. */
    double bottom() {
        return top() + scale * height(visibleRows);
    }

    private double left() {
        return Math.max(0, Math.rint(area.centreX() - scale * blockWidth / 2));
    }

    private double top() {
        return Math.max(0, Math.rint(area.centreY() - scale * height(visibleRows) / 2));
    }

    private double firstRow() {
        return top() + scale * (PADDING + TITLE_HEIGHT + linesHeight());
    }
}
