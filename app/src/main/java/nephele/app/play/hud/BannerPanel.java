package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** A title and a line in the upper part of the picture. Lengths are in points. */
final class BannerPanel {
    private static final double TITLE_EM = 36;
    private static final double LINE_EM = 20;
    private static final double PADDING = 18;
    private static final double TOP_SHARE = 0.12;

    private BannerPanel() {}

    static void draw(OverlayCanvas canvas, Area area, HudContent.Banner banner) {
        double widest = Math.max(canvas.width(TITLE_EM, banner.title()), canvas.width(LINE_EM, banner.line()));
        double scale = Math.min(1, area.width() / (widest + 4 * PADDING));
        double width = scale * (widest + 2 * PADDING);
        double height = scale * (TITLE_EM + LINE_EM + 3 * PADDING);
        double left = Math.rint(area.centreX() - width / 2);
        double top = Math.rint(TOP_SHARE * area.height());
        canvas.rectangle(left, top, width, height, HudPalette.PANEL);
        canvas.rectangle(left, top, width, 3, HudPalette.ACCENT);
        double x = left + scale * PADDING;
        double baseline = top + scale * (PADDING + 0.8 * TITLE_EM);
        canvas.text(x, baseline, scale * TITLE_EM, HudPalette.INK, banner.title());
        double below = baseline + scale * (PADDING + 0.8 * LINE_EM);
        canvas.text(x, below, scale * LINE_EM, HudPalette.QUIET_INK, banner.line());
    }
}
