package nephele.app.play.hud;

import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.host.playthrough.CrosshairState;
import nephele.host.playthrough.CrosshairState.Half;
import nephele.host.playthrough.CrosshairState.Shot;

/**
 * The crosshair: four short bars, or with a portal gun a half ring for each shot, left and right as the mouse buttons.
 * A half is filled if its portal exists, and dim and crossed out if a shot would place none. Dark edges below light
 * shapes make it visible on every background. Lengths are in points.
 */
final class Crosshair {
    private static final double GAP = 4;
    private static final double LENGTH = 7;
    private static final double WIDTH = 2;
    private static final double EDGE = 1;

    private static final double EM = 40;
    private static final double RADIUS = 0.36 * EM;
    /** The height from the glyphs' baseline to the ring's centre. */
    private static final double RISE = 0.35 * EM;

    private static final double APART = 2;
    private static final double CROSS_EM = 12;
    private static final double CROSS_WIDTH = 0.5 * CROSS_EM;
    private static final double CROSS_GAP = 7;
    private static final double REFUSED_ALPHA = 0.45;
    private static final double DOT = 3;

    private Crosshair() {}

    /** Returns the box of the crosshair with all its marks. */
    static Box box(Area area, HudContent.Sight sight) {
        double x = Math.rint(area.centreX() + sight.crosshair().right());
        double y = Math.rint(area.centreY() + sight.crosshair().down());
        double beside = sight.crosshair().first() == null
                ? GAP + LENGTH + EDGE
                : APART + RADIUS + CROSS_GAP + CROSS_WIDTH + 2 * EDGE;
        return new Box(x - beside, y - RADIUS, x + beside, y + RADIUS);
    }

    static void draw(OverlayCanvas canvas, Area area, HudContent.Sight sight) {
        CrosshairState crosshair = sight.crosshair();
        double x = Math.rint(area.centreX() + crosshair.right());
        double y = Math.rint(area.centreY() + crosshair.down());
        if (crosshair.first() == null) {
            bars(canvas, x, y);
            return;
        }
        bar(canvas, x - DOT / 2, y - DOT / 2, DOT, DOT);
        Half first = crosshair.first();
        Half second = crosshair.second();
        half(canvas, x - APART - RADIUS, y, first, first.isMade() ? "\ue002" : "\ue000", colour(sight, 0));
        half(canvas, x + APART, y, second, second.isMade() ? "\ue003" : "\ue001", colour(sight, 1));
        if (first.shot() == Shot.REFUSED) {
            cross(canvas, x - APART - RADIUS - CROSS_GAP - CROSS_WIDTH, y);
        }
        if (second.shot() == Shot.REFUSED) {
            cross(canvas, x + APART + RADIUS + CROSS_GAP, y);
        }
    }

    private static DisplayColour colour(HudContent.Sight sight, int shot) {
        return DisplayColour.opaque(sight.palette().overlay(shot));
    }

    /** @param glyph a half ring, filled or hollow */
    private static void half(
            OverlayCanvas canvas, double left, double y, Half half, String glyph, DisplayColour colour) {
        boolean opens = half.shot() == Shot.OPENS;
        edged(canvas, left, y + RISE, EM, opens ? colour : colour.withAlpha(REFUSED_ALPHA), glyph);
    }

    private static void cross(OverlayCanvas canvas, double left, double y) {
        edged(canvas, left, y + 0.35 * CROSS_EM, CROSS_EM, HudPalette.QUIET_INK, "X");
    }

    private static void edged(
            OverlayCanvas canvas, double x, double baseline, double em, DisplayColour colour, String letter) {
        canvas.text(x - EDGE, baseline, em, HudPalette.SHADOW, letter);
        canvas.text(x + EDGE, baseline, em, HudPalette.SHADOW, letter);
        canvas.text(x, baseline - EDGE, em, HudPalette.SHADOW, letter);
        canvas.text(x, baseline + EDGE, em, HudPalette.SHADOW, letter);
        canvas.text(x, baseline, em, colour, letter);
    }

    private static void bars(OverlayCanvas canvas, double x, double y) {
        bar(canvas, x - GAP - LENGTH, y - WIDTH / 2, LENGTH, WIDTH);
        bar(canvas, x + GAP, y - WIDTH / 2, LENGTH, WIDTH);
        bar(canvas, x - WIDTH / 2, y - GAP - LENGTH, WIDTH, LENGTH);
        bar(canvas, x - WIDTH / 2, y + GAP, WIDTH, LENGTH);
    }

    private static void bar(OverlayCanvas canvas, double x, double y, double width, double height) {
        canvas.rectangle(x - EDGE, y - EDGE, width + 2 * EDGE, height + 2 * EDGE, HudPalette.SHADOW);
        canvas.rectangle(x, y, width, height, HudPalette.INK);
    }
}
