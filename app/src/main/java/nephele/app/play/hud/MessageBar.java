package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * The latest messages at the lower edge, long ones in several lines. A low window shrinks them, and shows only as many
 * as fit below the line that names a key; a message that is longer alone is smaller, and its end is cut if even that is
 * too long. Lengths are in points.
 */
final class MessageBar {
    private static final double EM = 19;
    private static final double LINE_HEIGHT = 25;
    private static final double PADDING = 14;
    private static final double BOTTOM_FRACTION = 0.067;
    private static final double TOP_FRACTION = 0.78;
    private static final double WIDTH_FRACTION = 0.9;
    private static final double FULL_SIZE_HEIGHT = 540;
    private static final double LEAST_SCALE = 0.65;
    /** The scale of a long message in relation to a short one's. */
    private static final double LEAST_OF_LONG = 0.6;

    private static final double STEP = 0.9;

    private final OverlayCanvas canvas;
    private final Area area;
    private final Box room;
    private final double scale;
    private final List<String> lines = new ArrayList<>();
    private final Box box;

    /** @param room where they may be */
    MessageBar(OverlayCanvas canvas, Area area, Box room, List<String> messages) {
        this.canvas = canvas;
        this.area = area;
        this.room = room;
        String latest = messages.get(messages.size() - 1);
        double usual = Math.max(LEAST_SCALE, Math.min(1, area.height() / FULL_SIZE_HEIGHT));
        double fitting = usual;
        while (fitting > LEAST_OF_LONG * usual
                && !fits(fitting, broken(fitting, latest).size())) {
            fitting *= STEP;
        }
        scale = fitting;
        lines.addAll(cut(broken(scale, latest)));
        for (int i = messages.size() - 2; i >= 0; i--) {
            List<String> more = broken(scale, messages.get(i));
            if (!fits(scale, lines.size() + more.size())) {
                break;
            }
            lines.addAll(0, more);
        }
        box = boxOfLines();
    }

    private List<String> broken(double at, String message) {
        return TextLines.broken(canvas, at * EM, width(at), message);
    }

    /** Returns the greatest width of a line. */
    private double width(double at) {
        return Math.min(WIDTH_FRACTION * area.width(), room.width()) - 2 * at * PADDING;
    }

    private boolean fits(double at, int count) {
        return bottom() - at * (count * LINE_HEIGHT + 2 * PADDING) >= TOP_FRACTION * area.height();
    }

    private List<String> cut(List<String> whole) {
        int fitting = whole.size();
        while (fitting > 1 && !fits(scale, fitting)) {
            fitting--;
        }
        return TextLines.first(canvas, scale * EM, width(scale), whole, fitting);
    }

    private double bottom() {
        return Math.min(room.bottom(), Math.rint((1 - BOTTOM_FRACTION) * area.height()));
    }

    Box box() {
        return box;
    }

    private Box boxOfLines() {
        double widest = lines.stream()
                .mapToDouble(line -> canvas.width(scale * EM, line))
                .max()
                .orElse(0);
        double width = widest + 2 * scale * PADDING;
        double left = room.leftOf(width, area.centreX());
        double height = scale * (lines.size() * LINE_HEIGHT + 2 * PADDING);
        return new Box(left, bottom() - height, left + width, bottom());
    }

    void draw() {
        canvas.rectangle(box.left(), box.top(), box.width(), box.height(), HudPalette.PANEL);
        double baseline = box.top() + scale * (PADDING + 0.75 * LINE_HEIGHT);
        for (String line : lines) {
            canvas.text(box.left() + scale * PADDING, baseline, scale * EM, HudPalette.INK, line);
            baseline += scale * LINE_HEIGHT;
        }
    }
}
