package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * The mark of the goal after its key: brackets around it with its distance, or an arrow at the edge beyond which
 * it is. It keeps above the goal's words and the messages. Lengths are in points, from the picture's middle.
 *
 * @param arrow the arrow; empty for brackets
 * @param half half the side of the brackets
 */
public record GoalMark(double right, double down, String arrow, double half, long metres) {
    private static final double SIDE_FRACTION = 0.44;
    private static final double UPPER_FRACTION = 0.26;
    private static final double LOWER_FRACTION = 0.16;
    private static final double LEAST_HALF = 12;
    private static final double MOST_HALF_FRACTION = 0.14;
    private static final double EM = 18;
    private static final double PADDING = 6;
    private static final double WIDTH = 3;
    private static final double EDGE = 1;
    /** What is nearer to the middle covers the crosshair. */
    private static final double CROSSHAIR = 40;

    /**
     * Returns the mark of a goal.
     *
     * @param isAhead false if the goal is behind the eye; then only the signs of its place hold
     */
    public static GoalMark at(Area area, boolean isAhead, double right, double down, double half, long metres) {
        double side = SIDE_FRACTION * area.width();
        double upper = -UPPER_FRACTION * area.height();
        double lower = LOWER_FRACTION * area.height();
        if (!isAhead) {
            return new GoalMark(right < 0 ? -side : side, 0, right < 0 ? "←" : "→", 0, metres);
        }
        double x = halves(Math.max(-side, Math.min(side, right)));
        double y = halves(Math.max(upper, Math.min(lower, down)));
        if (Math.abs(right) > side) {
            return new GoalMark(x, y, right < 0 ? "←" : "→", 0, metres);
        } else if (down < upper || down > lower) {
            return new GoalMark(x, y, down < 0 ? "↑" : "↓", 0, metres);
        }
        double shown = Math.max(LEAST_HALF, Math.min(MOST_HALF_FRACTION * area.height(), half));
        return new GoalMark(x, y, "", halves(shown), metres);
    }

    /** Rounds to half points: the overlay is redrawn whenever it changes. */
    private static double halves(double points) {
        return Math.rint(2 * points) / 2 + 0.0;
    }

    void draw(OverlayCanvas canvas, Area area) {
        String text = (arrow.isEmpty() ? "" : arrow + " ") + metres + " m";
        double width = canvas.width(EM, text) + 2 * PADDING;
        double x = area.centreX() + right;
        double y = area.centreY() + down;
        if (!arrow.isEmpty()) {
            double left = Math.max(0, Math.min(area.width() - width, x - width / 2));
            label(canvas, left, y - (EM + 2 * PADDING) / 2, width, text);
            return;
        }
        for (int corner = 0; corner < 4; corner++) {
            bracket(canvas, x, y, corner % 2 == 0 ? -1 : 1, corner / 2 == 0 ? -1 : 1);
        }
        double above = down - half - PADDING - (EM + 2 * PADDING);
        boolean coversCrosshair = Math.abs(right) < CROSSHAIR && Math.abs(above + EM / 2 + PADDING) < CROSSHAIR;
        label(canvas, x - width / 2, coversCrosshair ? y + half + PADDING : area.centreY() + above, width, text);
    }

    private static void label(OverlayCanvas canvas, double left, double top, double width, String text) {
        canvas.rectangle(left, top, width, EM + 2 * PADDING, HudPalette.PANEL);
        canvas.text(left + PADDING, top + PADDING + 0.85 * EM, EM, HudPalette.INK, text);
    }

    /** Draws a corner, light above dark edges, so that it is visible on every background. */
    private void bracket(OverlayCanvas canvas, double x, double y, int sideways, int downwards) {
        double arm = 0.6 * half;
        double cornerX = x + sideways * half;
        double cornerY = y + downwards * half;
        double left = sideways < 0 ? cornerX : cornerX - arm;
        double top = downwards < 0 ? cornerY : cornerY - arm;
        double edge = downwards < 0 ? cornerY : cornerY - WIDTH;
        double side = sideways < 0 ? cornerX : cornerX - WIDTH;
        canvas.rectangle(left - EDGE, edge - EDGE, arm + 2 * EDGE, WIDTH + 2 * EDGE, HudPalette.HANDLE);
        canvas.rectangle(side - EDGE, top - EDGE, WIDTH + 2 * EDGE, arm + 2 * EDGE, HudPalette.HANDLE);
        canvas.rectangle(left, edge, arm, WIDTH, HudPalette.ACCENT);
        canvas.rectangle(side, top, WIDTH, arm, HudPalette.ACCENT);
    }
}
