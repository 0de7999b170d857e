package nephele.app.play.hud;

import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The F3 panel in the upper left corner: names left, values right. Lengths are in points. */
final class FrameStatisticsPanel {
    private static final double MARGIN = 12;
    private static final double PADDING = 12;
    private static final double WIDTH = 248;
    private static final double GAP = 8;
    private static final double LINE_HEIGHT = 21;
    private static final double EM = 16;
    /** The greatest fraction of the picture's width, so that the crosshair and what is beside the panel have room. */
    private static final double MOST_FRACTION = 0.4;

    private final List<HudContent.Figure> figures;
    private final double scale;

    /** A small window shrinks the panel, so that no line is left out. */
    FrameStatisticsPanel(Area area, List<HudContent.Figure> figures) {
        this.figures = figures;
        double fitting = area.height() / (height() + 2 * MARGIN);
        scale = Math.min(1, Math.min(fitting, MOST_FRACTION * area.width() / (MARGIN + WIDTH)));
    }

    private double height() {
        return 2 * PADDING + figures.size() * LINE_HEIGHT;
    }

    Box box() {
        double left = scale * MARGIN;
        return new Box(left, left, left + scale * WIDTH, left + scale * height());
    }

    void draw(OverlayCanvas canvas) {
        Box box = box();
        canvas.rectangle(box.left(), box.top(), box.width(), box.height(), HudPalette.PANEL);
        double room = scale * (WIDTH - 2 * PADDING - GAP);
        double baseline = scale * (MARGIN + PADDING + 0.7 * EM + 2);
        for (var figure : figures) {
            double wanted = canvas.width(scale * EM, figure.name()) + canvas.width(scale * EM, figure.value());
            double em = scale * EM * Math.min(1, room / wanted);
            double valueLeft = box.right() - scale * PADDING - canvas.width(em, figure.value());
            canvas.text(box.left() + scale * PADDING, baseline, em, HudPalette.QUIET_INK, figure.name());
            canvas.text(valueLeft, baseline, em, HudPalette.INK, figure.value());
            baseline += scale * LINE_HEIGHT;
        }
    }
}
