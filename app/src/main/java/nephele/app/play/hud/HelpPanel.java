package nephele.app.play.hud;

import java.util.List;
import nephele.app.settings.Phrase;
import nephele.app.window.Control;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The F1 page: the level's goal, then every key and its function. Lengths are in points. */
final class HelpPanel {
    static final double WIDTH = 560;
    static final double PADDING = 32;
    private static final double TITLE_EM = 32;
    private static final double ROW_HEIGHT = 26;
    static final double EM = 18;
    static final double KEY_COLUMN = 210;
    /** The rows of a level whose techniques are not compared. */
    static final int ROWS = Control.values().length + 1;

    private static final int WIPE_ROWS = 2;
    private static final int GOAL_ROWS = 2;
    private static final double SMALLER = 0.9;

    private HelpPanel() {}

    /** Returns the number of rows for this content. */
    static int rows(HudContent content) {
        return ROWS + (content.comparison() == null ? 0 : WIPE_ROWS) + (content.goal() == null ? 0 : GOAL_ROWS);
    }

    private static double full(int rows) {
        return 2 * PADDING + 2 * TITLE_EM + rows * ROW_HEIGHT;
    }

    /** Returns the page's scale, at most 1: a small room shrinks the page, so that no key is left out. */
    static double scale(Box room, int rows) {
        return Math.min(1, Math.min(room.height() / full(rows), room.width() / WIDTH));
    }

    /** @param room where the page may be */
    static Box box(Area area, Box room, int rows) {
        double width = scale(room, rows) * WIDTH;
        double height = scale(room, rows) * full(rows);
        double left = room.leftOf(width, area.centreX());
        double top = Math.max(room.top(), Math.min(Math.rint(area.centreY() - height / 2), room.bottom() - height));
        return new Box(left, top, left + width, top + height);
    }

    /** @param rows see {@link #rows} */
    static void draw(OverlayCanvas canvas, Box box, HudContent content, int rows) {
        HudContent.Keys keys = content.keys();
        double scale = box.height() / full(rows);
        double left = box.left();
        double top = box.top();
        canvas.rectangle(left, top, box.width(), box.height(), HudPalette.PANEL);
        canvas.rectangle(left, top, box.width(), 3, HudPalette.ACCENT);
        double x = left + scale * PADDING;
        canvas.text(
                x,
                top + scale * (PADDING + 0.7 * TITLE_EM),
                scale * TITLE_EM,
                HudPalette.INK,
                Phrase.KEYS.in(keys.language()));
        double baseline = top + scale * (PADDING + 2 * TITLE_EM + 0.5 * ROW_HEIGHT);
        if (content.goal() != null) {
            goal(
                    canvas,
                    x,
                    baseline,
                    scale,
                    Phrase.GOAL.in(keys.language()) + ": " + content.goal().line());
            baseline += GOAL_ROWS * scale * ROW_HEIGHT;
        }
        row(canvas, x, baseline, scale, keys.look(), Phrase.LOOK.in(keys.language()));
        for (var control : Control.values()) {
            baseline += scale * ROW_HEIGHT;
            row(canvas, x, baseline, scale, keys.names(control), keys.meaning(control));
        }
        if (content.comparison() != null) {
            double below = scale * ROW_HEIGHT;
            row(canvas, x, baseline + below, scale, wipeKeys(keys, "Left", "Right"), keys.withRun(Phrase.MOVE_WIPE));
            String ends = wipeKeys(keys, "Home", "End");
            row(canvas, x, baseline + 2 * below, scale, ends, Phrase.WHOLE_SIDE.in(keys.language()));
        }
    }

    /** Draws the goal in at most two lines; a longer one is smaller. */
    private static void goal(OverlayCanvas canvas, double x, double baseline, double scale, String text) {
        double em = scale * EM;
        List<String> lines = TextLines.broken(canvas, em, scale * (WIDTH - 2 * PADDING), text);
        while (lines.size() > GOAL_ROWS) {
            em *= SMALLER;
            lines = TextLines.broken(canvas, em, scale * (WIDTH - 2 * PADDING), text);
        }
        for (int i = 0; i < lines.size(); i++) {
            canvas.text(x, baseline - 0.25 * scale * ROW_HEIGHT + i * 1.2 * em, em, HudPalette.INK, lines.get(i));
        }
    }

    private static String wipeKeys(HudContent.Keys keys, String one, String other) {
        return Phrase.ofKey(one, keys.language()) + ", " + Phrase.ofKey(other, keys.language());
    }

    /** Draws a row; a meaning that is longer than the page is smaller. */
    private static void row(
            OverlayCanvas canvas, double x, double baseline, double scale, String keys, String meaning) {
        double room = scale * (WIDTH - 2 * PADDING - KEY_COLUMN);
        double em = scale * EM * Math.min(1, room / canvas.width(scale * EM, meaning));
        canvas.text(x, baseline, scale * EM, HudPalette.ACCENT, keys);
        canvas.text(x + scale * KEY_COLUMN, baseline, em, HudPalette.INK, meaning);
    }
}
