package nephele.app.play.hud;

import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The F3 panel in the upper left corner: names left, values right. Lengths are in points. */
final class FrameStatisticsPanel {
    private static final double MARGIN = 12;
    private static final double PADDING = 12;
    private static final double WIDTH = 248;
    private static final double LINE_HEIGHT = 21;
    private static final double EM = 16;

    private FrameStatisticsPanel() {}

    /** A low window shrinks the panel, so that no line is left out. */
    static void draw(OverlayCanvas canvas, Area area, List<HudContent.Figure> figures) {
        double height = 2 * PADDING + figures.size() * LINE_HEIGHT;
        double scale = Math.min(1, area.height() / (height + 2 * MARGIN));
        double em = scale * EM;
        double left = scale * MARGIN;
        canvas.rectangle(left, left, scale * WIDTH, scale * height, HudPalette.PANEL);
        double baseline = scale * (MARGIN + PADDING + 0.7 * EM + 2);
        for (var figure : figures) {
            double valueLeft = scale * (MARGIN + WIDTH - PADDING) - canvas.width(em, figure.value());
            canvas.text(scale * (MARGIN + PADDING), baseline, em, HudPalette.QUIET_INK, figure.name());
            canvas.text(valueLeft, baseline, em, HudPalette.INK, figure.value());
            baseline += scale * LINE_HEIGHT;
        }
    }
}
