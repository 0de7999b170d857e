package nephele.app.play.hud;

import java.util.List;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;

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
    /** The most that a label takes of a row with a value. */
    private static final double LABEL_FRACTION = 0.72;

    /** The size of a value in relation to its label's. */
    private static final double VALUE_FRACTION = 0.85;
    /** The estimated mean width of a letter, in ems. */
    private static final double LETTER_EMS = 0.5;

    private static final double FOOT_HEIGHT = 34;
    private static final double FOOT_EM = 15;
    private static final double FOOT_LINE_EMS = 1.27;
    private static final int FOOT_LINES = 2;
    private static final double LEAST_FOOT_EM = 10;
    private static final double LEAST_SCALE = 0.62;
    private static final double GAP = 14;
    /** The height for the lines of a message: from the entries to the panel's edge, less what hangs below a line. */
    private static final double FOOT_ROOM = FOOT_HEIGHT + PADDING - 2;

    private static final double HELP_HEIGHT = 62;
    private static final double HELP_EM = 17;
    private static final int HELP_LINES = 2;
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
        blockWidth = WIDTH + (menu.hasCards() ? BESIDE + CardPanel.WIDTH : 0);
        double wanted = Math.min(area.height() / height(rows), area.width() / (blockWidth + 2 * BESIDE));
        scale = Math.max(LEAST_SCALE, Math.min(1, wanted));
        int fitting = (int) Math.floor((area.height() / scale - height(0)) / ROW_HEIGHT);
        visibleRows = Math.max(1, Math.min(rows, fitting));
        firstVisible = Math.max(0, Math.min(menu.centred() - visibleRows / 2, rows - visibleRows));
    }

    private double height(int rows) {
        return PADDING + TITLE_HEIGHT + linesHeight() + rows * ROW_HEIGHT + helpHeight() + FOOT_HEIGHT + PADDING;
    }

    private double linesHeight() {
        return menu.lines().isEmpty() ? 0 : menu.lines().size() * LINE_HEIGHT + GAP;
    }

    private double helpHeight() {
        return menu.hasHelp() ? HELP_HEIGHT : 0;
    }

    /** Returns the row under a point, or −1. */
    public int rowAt(double x, double y) {
        boolean beside = x < left() || x > left() + scale * WIDTH;
        int row = (int) Math.floor((y - firstRow()) / (scale * ROW_HEIGHT));
        return beside || row < 0 || row >= visibleRows ? -1 : firstVisible + row;
    }

    /** Returns the row about which the list is shown after it has moved by so many rows. */
    public int scrolled(int rows) {
        int last = menu.entries().size() - visibleRows;
        return Math.max(0, Math.min(last, firstVisible + rows)) + visibleRows / 2;
    }

    /** Returns the step of a setting for a click: back (−1) on the left half of its value, forward elsewhere. */
    public int stepAt(int row, double x) {
        double width = scale
                * VALUE_FRACTION
                * ROW_EM
                * LETTER_EMS
                * menu.entries().get(row).value().length();
        double fromRight = left() + scale * (WIDTH - PADDING) - x;
        return fromRight > width / 2 && fromRight < width + scale * GAP ? -1 : 1;
    }

    /** Draws the menu with its own foot. */
    void draw(OverlayCanvas canvas) {
        draw(canvas, menu.foot(), HudPalette.QUIET_INK);
    }

    /** @param foot the text below the entries, see {@link #foot} */
    void draw(OverlayCanvas canvas, String foot, DisplayColour ink) {
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
        drawHelp(canvas, x);
        drawFoot(canvas, x, foot, ink);
        drawCard(canvas);
        drawArrows(canvas);
    }

    private void drawCard(OverlayCanvas canvas) {
        Menu.Card card = menu.entry().card();
        if (card != null) {
            double x = left() + scale * (WIDTH + BESIDE);
            new CardPanel(card, scale).draw(canvas, x, top(), area.height() - top());
        }
    }

    private void drawHelp(OverlayCanvas canvas, double x) {
        if (!menu.hasHelp()) {
            return;
        }
        double y = firstRow() + scale * visibleRows * ROW_HEIGHT;
        canvas.rectangle(x, y + scale * GAP / 2, scale * (WIDTH - 2 * PADDING - GAP), 1, HudPalette.SELECTED);
        double em = HELP_EM;
        List<String> lines =
                TextLines.broken(canvas, em, WIDTH - 2 * PADDING, menu.entry().help());
        if (lines.size() > HELP_LINES) {
            em = HELP_EM * HELP_LINES / (HELP_LINES + 0.5);
            lines = TextLines.broken(
                    canvas, em, WIDTH - 2 * PADDING, menu.entry().help());
        }
        double line = (HELP_HEIGHT - GAP) / Math.max(HELP_LINES, lines.size());
        double baseline = y + scale * (GAP + em);
        for (String text : lines) {
            canvas.text(x, baseline, scale * em, HudPalette.INK, text);
            baseline += scale * line;
        }
    }

    /**
     * Returns the lines of a foot. Those of a message begin right below the entries, as large as fits above the panel's
     * lower edge; the end of one that is too long even for the smallest letters is cut.
     */
    static TextLines foot(OverlayCanvas canvas, String text) {
        double width = WIDTH - 2 * PADDING;
        List<String> lines = TextLines.broken(canvas, FOOT_EM, width, text);
        if (lines.size() <= FOOT_LINES) {
            return new TextLines(FOOT_EM, lines);
        }
        double em = FOOT_EM;
        while (em > LEAST_FOOT_EM && lines.size() > mostFootLines(em)) {
            em--;
            lines = TextLines.broken(canvas, em, width, text);
        }
        return new TextLines(em, TextLines.first(canvas, em, width, lines, mostFootLines(em)));
    }

    private static int mostFootLines(double em) {
        return (int) (FOOT_ROOM / (em * FOOT_LINE_EMS));
    }

    /** Returns the distance of a foot's first baseline from the entries. */
    static double firstBaseline(TextLines foot) {
        return foot.lines().size() <= FOOT_LINES ? FOOT_HEIGHT : foot.em();
    }

    private void drawFoot(OverlayCanvas canvas, double x, String text, DisplayColour ink) {
        TextLines foot = foot(canvas, text);
        double rowsEnd = firstRow() + scale * (visibleRows * ROW_HEIGHT + helpHeight());
        double baseline = rowsEnd + scale * firstBaseline(foot);
        for (String line : foot.lines()) {
            canvas.text(x, baseline, scale * foot.em(), ink, line);
            baseline += scale * foot.em() * FOOT_LINE_EMS;
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
        double x = left() + scale * (WIDTH - PADDING / 2 - FOOT_EM / 2);
        if (firstVisible > 0) {
            canvas.text(x, firstRow() + scale * FOOT_EM, scale * FOOT_EM, HudPalette.ACCENT, "↑");
        }
        if (firstVisible + visibleRows < menu.entries().size()) {
            double bottom = firstRow() + scale * visibleRows * ROW_HEIGHT;
            canvas.text(x, bottom - scale * 4, scale * FOOT_EM, HudPalette.ACCENT, "↓");
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
        double whole = scale * (WIDTH - 2 * PADDING) * (entry.value().isEmpty() ? 1 : LABEL_FRACTION);
        double labelEm = em * Math.min(1, whole / canvas.width(em, entry.label()));
        double end = canvas.text(left() + scale * PADDING, baseline, labelEm, ink, entry.label());
        if (!entry.value().isEmpty()) {
            double valueEm = VALUE_FRACTION * em;
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
