package nephele.app.play.hud;

import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** The latest messages at the lower edge, long ones in several lines. Lengths are in points. */
final class MessageBar {
    private static final double EM = 19;
    private static final double LINE_HEIGHT = 25;
    private static final double PADDING = 14;
    private static final double BOTTOM_SHARE = 0.067;
    private static final double WIDTH_SHARE = 0.9;

    private final List<String> lines;
    private final Area area;

    MessageBar(OverlayCanvas canvas, Area area, List<String> messages) {
        this.area = area;
        double room = WIDTH_SHARE * area.width() - 2 * PADDING;
        lines = messages.stream()
                .flatMap(message -> TextLines.of(canvas, EM, room, message).stream())
                .toList();
    }

    /** Returns the upper edge. */
    double top() {
        return Math.rint((1 - BOTTOM_SHARE) * area.height()) - height();
    }

    private double height() {
        return lines.size() * LINE_HEIGHT + 2 * PADDING;
    }

    void draw(OverlayCanvas canvas) {
        double widest =
                lines.stream().mapToDouble(line -> canvas.width(EM, line)).max().orElse(0);
        double left = Math.rint(area.centreX() - widest / 2 - PADDING);
        canvas.rectangle(left, top(), widest + 2 * PADDING, height(), HudPalette.PANEL);
        double baseline = top() + PADDING + 0.75 * LINE_HEIGHT;
        for (String line : lines) {
            canvas.text(left + PADDING, baseline, EM, HudPalette.INK, line);
            baseline += LINE_HEIGHT;
        }
    }
}
