package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The menu in the middle of the picture. Lengths are in points. */
public final class MenuPanel {
    private static final double WIDTH = 380;
    private static final double PADDING = 32;
    private static final double TITLE_EM = 44;
    private static final double TITLE_HEIGHT = 76;
    private static final double ROW_HEIGHT = 46;
    private static final double ROW_EM = 23;
    private static final double FOOT_HEIGHT = 34;
    private static final double FOOT_EM = 15;

    private final Menu menu;
    private final Area area;

    public MenuPanel(Menu menu, Area area) {
        this.menu = menu;
        this.area = area;
    }

    /** Returns the row under a point, or −1. */
    public int rowAt(double x, double y) {
        boolean beside = x < left() || x > left() + WIDTH;
        int row = (int) Math.floor((y - firstRow()) / ROW_HEIGHT);
        return beside || row < 0 || row >= menu.entries().size() ? -1 : row;
    }

    void draw(OverlayCanvas canvas) {
        canvas.rectangle(0, 0, area.width(), area.height(), HudPalette.VEIL);
        canvas.rectangle(left(), top(), WIDTH, height(), HudPalette.PANEL);
        canvas.rectangle(left(), top(), WIDTH, 3, HudPalette.ACCENT);
        canvas.text(left() + PADDING, top() + PADDING + 0.7 * TITLE_EM, TITLE_EM, HudPalette.INK, menu.title());
        for (int row = 0; row < menu.entries().size(); row++) {
            drawRow(canvas, row);
        }
        double foot = firstRow() + menu.entries().size() * ROW_HEIGHT + FOOT_HEIGHT;
        canvas.text(left() + PADDING, foot, FOOT_EM, HudPalette.QUIET_INK, "↑ ↓  Enter  or mouse     Esc  " + escape());
    }

    private String escape() {
        return menu.escape() instanceof Menu.Choice.Back ? "back" : "continue";
    }

    private void drawRow(OverlayCanvas canvas, int row) {
        double y = firstRow() + row * ROW_HEIGHT;
        boolean selected = row == menu.selected();
        if (selected) {
            canvas.rectangle(left(), y, WIDTH, ROW_HEIGHT, HudPalette.SELECTED);
            canvas.rectangle(left(), y, 4, ROW_HEIGHT, HudPalette.ACCENT);
        }
        double baseline = y + ROW_HEIGHT / 2 + 0.35 * ROW_EM;
        var label = menu.entries().get(row).label();
        canvas.text(left() + PADDING, baseline, ROW_EM, selected ? HudPalette.INK : HudPalette.QUIET_INK, label);
    }

    private double left() {
        return Math.rint(area.centreX() - WIDTH / 2);
    }

    private double top() {
        return Math.max(0, Math.rint(area.centreY() - height() / 2));
    }

    private double firstRow() {
        return top() + PADDING + TITLE_HEIGHT;
    }

    private double height() {
        return PADDING + TITLE_HEIGHT + menu.entries().size() * ROW_HEIGHT + FOOT_HEIGHT + PADDING;
    }
}
