package nephele.editor.draw;

import nephele.editor.draw.PaneInset.LegendLine;
import nephele.editor.draw.PaneInset.Pattern;
import nephele.engine.render.line.LineColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayColour;

/** Fills the canvases of a pane with its legend and its small picture, from the lower right corner upwards. */
record InsetDrawing(OverlayCanvas texts, double pixelsPerPoint) {
    private static final double MARGIN_POINTS = 10;
    private static final double PAD_POINTS = 6;
    private static final double EM_POINTS = 12;
    private static final double ROW_POINTS = 19;
    private static final double SWATCH_POINTS = 15;
    private static final double STRIPE_POINTS = 5;
    private static final OverlayColour PLATE = new OverlayColour(0.05f, 0.06f, 0.07f, 0.82f);
    private static final OverlayColour FRAME = new OverlayColour(0.6f, 0.64f, 0.68f, 1);
    private static final LineColour STRIPE = LineColour.of(0x101214, 1);

    /** @param width of the pane in pixels, {@code height} likewise */
    void add(PaneInset inset, int width, int height) {
        double right = width / pixelsPerPoint - MARGIN_POINTS;
        double bottom = height / pixelsPerPoint - MARGIN_POINTS;
        if (inset.picture() != null) {
            bottom = picture(inset, right, bottom) - MARGIN_POINTS;
        }
        if (!inset.legend().isEmpty()) {
            legend(inset, right, bottom);
        }
    }

    /** Returns the upper border. */
    private double picture(PaneInset inset, double right, double bottom) {
        double width = shownWidth(inset, right);
        double height = width * inset.picture().height() / inset.picture().width();
        double left = right - width;
        double plate = ROW_POINTS;
        double top = bottom - height - plate;
        texts.rectangle(left - 1, top - 1, width + 2, height + plate + 2, FRAME);
        texts.rectangle(left, top, width, plate, OverlayColour.opaque(0x14171a));
        texts.picture(left, top + plate, width, height, inset.picture());
        texts.text(left + PAD_POINTS, top + 14, EM_POINTS, OverlayColour.opaque(0xdfe4e8), inset.caption());
        return top;
    }

    private double shownWidth(PaneInset inset, double right) {
        double letters = texts.width(EM_POINTS, inset.caption()) + 2 * PAD_POINTS;
        return Math.min(right - MARGIN_POINTS, Math.max(letters, 0.38 * (right + MARGIN_POINTS)));
    }

    private void legend(PaneInset inset, double right, double bottom) {
        double widest = inset.legend().stream()
                .mapToDouble(line -> texts.width(EM_POINTS, line.text()))
                .max()
                .orElse(0);
        double width = widest + SWATCH_POINTS + 3 * PAD_POINTS;
        double height = inset.legend().size() * ROW_POINTS + PAD_POINTS;
        double left = right - width;
        double top = bottom - height;
        texts.rectangle(left, top, width, height, PLATE);
        double y = top + PAD_POINTS / 2;
        for (LegendLine line : inset.legend()) {
            row(line, left + PAD_POINTS, y);
            y += ROW_POINTS;
        }
    }

    private void row(LegendLine line, double x, double y) {
        OverlayColour colour = MarkDrawing.overlay(MarkPalette.ON_DARK.of(line.colour()));
        double top = y + (ROW_POINTS - SWATCH_POINTS) / 2;
        texts.rectangle(x, top, SWATCH_POINTS, SWATCH_POINTS, colour);
        stripes(line.pattern(), x, top);
        texts.text(x + SWATCH_POINTS + PAD_POINTS, y + 14, EM_POINTS, OverlayColour.opaque(0xdfe4e8), line.text());
    }

    /** Small squares along the diagonals: the canvas of letters has no slanted lines, and covers those that have. */
    private void stripes(Pattern pattern, double x, double y) {
        OverlayColour dark = MarkDrawing.overlay(STRIPE);
        double dot = 1.5;
        for (double at = 0; at <= SWATCH_POINTS - dot; at += 0.5) {
            for (double shift = -2 * STRIPE_POINTS;
                    shift <= 2 * STRIPE_POINTS && pattern != Pattern.PLAIN;
                    shift += STRIPE_POINTS + 2) {
                double across = at + shift;
                if (across >= 0 && across <= SWATCH_POINTS - dot) {
                    texts.rectangle(x + at, y + SWATCH_POINTS - dot - across, dot, dot, dark);
                    if (pattern == Pattern.CROSSED) {
                        texts.rectangle(x + at, y + across, dot, dot, dark);
                    }
                }
            }
        }
    }
}
