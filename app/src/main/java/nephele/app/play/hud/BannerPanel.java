package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** A title and a line in the upper part of the picture. Lengths are in points. */
final class BannerPanel {
    private static final double TITLE_EM = 36;
    private static final double LINE_EM = 20;
    private static final double PADDING = 18;
    private static final double TOP_SHARE = 0.12;
    private static final double HEIGHT = TITLE_EM + LINE_EM + 3 * PADDING;
    private static final double FULL_SIZE_HEIGHT = 540;

    private final HudContent.Banner banner;
    private final double scale;
    private final Box box;

    /** @param room where it may be; a banner that is higher or wider is smaller */
    BannerPanel(OverlayCanvas canvas, Area area, Box room, HudContent.Banner banner) {
        this.banner = banner;
        double widest = Math.max(canvas.width(TITLE_EM, banner.title()), canvas.width(LINE_EM, banner.line()));
        double low = Math.min(area.height() / FULL_SIZE_HEIGHT, room.height() / HEIGHT);
        scale = Math.min(1, Math.min(low, room.width() / (widest + 4 * PADDING)));
        double width = scale * (widest + 2 * PADDING);
        double left = room.leftOf(width, area.centreX());
        double top =
                Math.max(room.top(), Math.min(Math.rint(TOP_SHARE * area.height()), room.bottom() - scale * HEIGHT));
        box = new Box(left, top, left + width, top + scale * HEIGHT);
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
        canvas.text(x, below, scale * LINE_EM, HudPalette.QUIET_INK, banner.line());
    }
}
