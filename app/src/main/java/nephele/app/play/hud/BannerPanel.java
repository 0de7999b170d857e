package nephele.app.play.hud;

import java.util.List;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** A title and a line in the upper part of the picture, or in the lower one. Lengths are in points. */
final class BannerPanel {
    /** Places of the upper edge in the picture's height: the usual one, and as low as the room allows. */
    static final double UPPER_FRACTION = 0.12;

    static final double LOWEST_FRACTION = 1;

    private static final double TITLE_EM = 36;
    private static final double LINE_EM = 20;
    private static final double PADDING = 18;
    private static final double LINE_HEIGHT = 1.3 * LINE_EM;
    private static final double FULL_SIZE_HEIGHT = 540;
    private static final double LEAST_SCALE = 0.62;

    private final HudContent.Banner banner;
    private final List<String> lines;
    private final double usual;
    private final double scale;
    private final Box box;

    /** @param room where it may be; a long line is broken, and a banner that is higher or wider still is smaller */
    BannerPanel(OverlayCanvas canvas, Area area, Box room, HudContent.Banner banner, double topFraction) {
        this.banner = banner;
        usual = Math.min(1, Math.max(LEAST_SCALE, area.height() / FULL_SIZE_HEIGHT));
        lines = TextLines.broken(canvas, LINE_EM, Math.max(LINE_EM, room.width() / usual - 4 * PADDING), banner.line());
        double widest = canvas.width(TITLE_EM, banner.title());
        for (String line : lines) {
            widest = Math.max(widest, canvas.width(LINE_EM, line));
        }
        double height = TITLE_EM + LINE_EM + (lines.size() - 1) * LINE_HEIGHT + 3 * PADDING;
        double low = Math.min(usual, room.height() / height);
        scale = Math.min(1, Math.min(low, room.width() / (widest + 4 * PADDING)));
        double width = scale * (widest + 2 * PADDING);
        double left = room.leftOf(width, area.centreX());
        double top =
                Math.max(room.top(), Math.min(Math.rint(topFraction * area.height()), room.bottom() - scale * height));
        box = new Box(left, top, left + width, top + scale * height);
    }

    /** Returns true if the letters are as large as elsewhere. */
    boolean isWhole() {
        return scale == usual;
    }

    Box box() {
        return box;
    }

    void draw(OverlayCanvas canvas) {
        canvas.rectangle(box.left(), box.top(), box.width(), box.height(), HudPalette.PANEL);
        canvas.rectangle(box.left(), box.top(), box.width(), 3, HudPalette.ACCENT);
        double x = box.left() + scale * PADDING;
        double baseline = box.top() + scale * (PADDING + 0.8 * TITLE_EM);
        canvas.text(x, baseline, scale * TITLE_EM, HudPalette.INK, banner.title());
        double below = baseline + scale * (PADDING + 0.8 * LINE_EM);
        for (String line : lines) {
            canvas.text(x, below, scale * LINE_EM, HudPalette.QUIET_INK, line);
            below += scale * LINE_HEIGHT;
        }
    }
}
