package nephele.editor.draw;

import java.util.List;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * The lower right corner of a pane, above its picture: a legend of colours, and a small picture.
 *
 * @param picture {@code null} for none
 * @param caption of the picture
 */
public record PaneInset(List<LegendLine> legend, Picture picture, String caption) {
    public static final PaneInset NONE = new PaneInset(List.of(), null, "");

    private static final double MARGIN_POINTS = 10;
    private static final double PAD_POINTS = 6;
    private static final double EM_POINTS = 12;
    private static final double ROW_POINTS = 19;
    private static final double SWATCH_POINTS = 15;
    private static final double STRIPE_POINTS = 5;
    private static final DisplayColour PLATE = new DisplayColour(0.05f, 0.06f, 0.07f, 0.82f);
    private static final DisplayColour FRAME = new DisplayColour(0.6f, 0.64f, 0.68f, 1);
    private static final DisplayColour STRIPE = DisplayColour.of(0x101214, 1);

    /** The pattern of lines on an area, as the marks of the map have it. */
    public enum Pattern {
        PLAIN,
        SLANTED,
        CROSSED
    }

    /** A colour and its meaning. */
    public record LegendLine(MarkColour colour, Pattern pattern, String text) {}

    public PaneInset {
        legend = List.copyOf(legend);
    }

    /** Draws the inset, from the lower right corner of the pane upwards. */
    void draw(OverlayCanvas texts, PaneSize pane, double pixelsPerPoint) {
        double right = pane.width() / pixelsPerPoint - MARGIN_POINTS;
        double bottom = pane.height() / pixelsPerPoint - MARGIN_POINTS;
        if (picture != null) {
            bottom = drawPicture(texts, right, bottom) - MARGIN_POINTS;
        }
        if (!legend.isEmpty()) {
            drawLegend(texts, right, bottom);
        }
    }

    /** Returns the picture's upper border. */
    private double drawPicture(OverlayCanvas texts, double right, double bottom) {
        double width = pictureWidth(texts, right);
        double height = width * picture.height() / picture.width();
        double left = right - width;
        double plate = ROW_POINTS;
        double top = bottom - height - plate;
        texts.rectangle(left - 1, top - 1, width + 2, height + plate + 2, FRAME);
        texts.rectangle(left, top, width, plate, DisplayColour.opaque(0x14171a));
        texts.picture(left, top + plate, width, height, picture);
        texts.text(left + PAD_POINTS, top + 14, EM_POINTS, DisplayColour.opaque(0xdfe4e8), caption);
        return top;
    }

    private double pictureWidth(OverlayCanvas texts, double right) {
        double letters = texts.width(EM_POINTS, caption) + 2 * PAD_POINTS;
        return Math.min(right - MARGIN_POINTS, Math.max(letters, 0.38 * (right + MARGIN_POINTS)));
    }

    private void drawLegend(OverlayCanvas texts, double right, double bottom) {
        double widest = legend.stream()
                .mapToDouble(line -> texts.width(EM_POINTS, line.text()))
                .max()
                .orElse(0);
        double width = widest + SWATCH_POINTS + 3 * PAD_POINTS;
        double height = legend.size() * ROW_POINTS + PAD_POINTS;
        double left = right - width;
        double top = bottom - height;
        texts.rectangle(left, top, width, height, PLATE);
        double y = top + PAD_POINTS / 2;
        for (LegendLine line : legend) {
            drawRow(texts, line, left + PAD_POINTS, y);
            y += ROW_POINTS;
        }
    }

    private static void drawRow(OverlayCanvas texts, LegendLine line, double x, double y) {
        DisplayColour colour = Background.DARK.shade(line.colour());
        double top = y + (ROW_POINTS - SWATCH_POINTS) / 2;
        texts.rectangle(x, top, SWATCH_POINTS, SWATCH_POINTS, colour);
        drawStripes(texts, line.pattern(), x, top);
        texts.text(x + SWATCH_POINTS + PAD_POINTS, y + 14, EM_POINTS, DisplayColour.opaque(0xdfe4e8), line.text());
    }

    /** Small squares along the diagonals: the canvas of letters has no slanted lines, and covers those that have. */
    private static void drawStripes(OverlayCanvas texts, Pattern pattern, double x, double y) {
        double dot = 1.5;
        for (double at = 0; at <= SWATCH_POINTS - dot; at += 0.5) {
            for (double shift = -2 * STRIPE_POINTS;
                    shift <= 2 * STRIPE_POINTS && pattern != Pattern.PLAIN;
                    shift += STRIPE_POINTS + 2) {
                double across = at + shift;
                if (across >= 0 && across <= SWATCH_POINTS - dot) {
                    texts.rectangle(x + at, y + SWATCH_POINTS - dot - across, dot, dot, STRIPE);
                    if (pattern == Pattern.CROSSED) {
                        texts.rectangle(x + at, y + across, dot, dot, STRIPE);
                    }
                }
            }
        }
    }
}
