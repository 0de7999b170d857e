package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * The latest messages at the lower edge, long ones in several lines. A low window shrinks them, and shows only as many
 * as fit below the line that names a key. Lengths are in points.
 */
final class MessageBar {
    private static final double EM = 19;
    private static final double LINE_HEIGHT = 25;
    private static final double PADDING = 14;
    private static final double BOTTOM_SHARE = 0.067;
    private static final double TOP_SHARE = 0.77;
    private static final double WIDTH_SHARE = 0.9;
    private static final double FULL_SIZE_HEIGHT = 540;
    private static final double LEAST_SCALE = 0.65;

    private final List<String> lines = new ArrayList<>();
    private final Area area;
    private final double scale;

    MessageBar(OverlayCanvas canvas, Area area, List<String> messages) {
        this.area = area;
        scale = Math.max(LEAST_SCALE, Math.min(1, area.height() / FULL_SIZE_HEIGHT));
        double room = WIDTH_SHARE * area.width() - 2 * PADDING;
        for (int i = messages.size() - 1; i >= 0; i--) {
            List<String> more = TextLines.of(canvas, scale * EM, room, messages.get(i));
            if (!lines.isEmpty() && bottom() - height(lines.size() + more.size()) < TOP_SHARE * area.height()) {
                break;
            }
            lines.addAll(0, more);
        }
    }

    /** Returns the upper edge. */
    double top() {
        return bottom() - height(lines.size());
    }

    private double bottom() {
        return Math.rint((1 - BOTTOM_SHARE) * area.height());
    }

    private double height(int count) {
        return scale * (count * LINE_HEIGHT + 2 * PADDING);
    }

    void draw(OverlayCanvas canvas) {
        double em = scale * EM;
        double padding = scale * PADDING;
        double widest =
                lines.stream().mapToDouble(line -> canvas.width(em, line)).max().orElse(0);
        double left = Math.rint(area.centreX() - widest / 2 - padding);
        canvas.rectangle(left, top(), widest + 2 * padding, height(lines.size()), HudPalette.PANEL);
        double baseline = top() + padding + 0.75 * scale * LINE_HEIGHT;
        for (String line : lines) {
            canvas.text(left + padding, baseline, em, HudPalette.INK, line);
            baseline += scale * LINE_HEIGHT;
        }
    }
}
