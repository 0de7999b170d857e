package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayCanvas;

/** Four short bars around the middle, dark below light so that they show on every background. */
final class Crosshair {
    private static final double GAP = 4;
    private static final double LENGTH = 7;
    private static final double WIDTH = 2;
    private static final double EDGE = 1;

    private Crosshair() {}

    static void draw(OverlayCanvas canvas, Area area) {
        double x = Math.rint(area.centreX());
        double y = Math.rint(area.centreY());
        bar(canvas, x - GAP - LENGTH, y - WIDTH / 2, LENGTH, WIDTH);
        bar(canvas, x + GAP, y - WIDTH / 2, LENGTH, WIDTH);
        bar(canvas, x - WIDTH / 2, y - GAP - LENGTH, WIDTH, LENGTH);
        bar(canvas, x - WIDTH / 2, y + GAP, WIDTH, LENGTH);
    }

    private static void bar(OverlayCanvas canvas, double x, double y, double width, double height) {
        canvas.rectangle(x - EDGE, y - EDGE, width + 2 * EDGE, height + 2 * EDGE, Palette.SHADOW);
        canvas.rectangle(x, y, width, height, Palette.INK);
    }
}
