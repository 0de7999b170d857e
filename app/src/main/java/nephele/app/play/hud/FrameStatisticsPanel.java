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

    static void draw(OverlayCanvas canvas, List<HudContent.Figure> figures) {
        double height = 2 * PADDING + figures.size() * LINE_HEIGHT;
        canvas.rectangle(MARGIN, MARGIN, WIDTH, height, HudPalette.PANEL);
        double baseline = MARGIN + PADDING + 0.7 * EM + 2;
        for (var figure : figures) {
            double valueLeft = MARGIN + WIDTH - PADDING - canvas.width(EM, figure.value());
            canvas.text(MARGIN + PADDING, baseline, EM, HudPalette.QUIET_INK, figure.name());
            canvas.text(valueLeft, baseline, EM, HudPalette.INK, figure.value());
            baseline += LINE_HEIGHT;
        }
    }
}
