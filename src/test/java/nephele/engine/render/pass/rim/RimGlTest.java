package nephele.engine.render.pass.rim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Rims are distinguishable with and without colour vision, never black or uniform, and can be disabled. */
class RimGlTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 360;
    private static final double EYE_METRES = 2.2;
    private static final PortalGun GUN = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);
    private static final Vec3 LEFT = new Vec3(-1.1, 1.2, 0);
    private static final Vec3 RIGHT = new Vec3(1.1, 1.2, 0);

    /** A pale wall at z = 0 and a floor. */
    private static Level wall() {
        var environment =
                new Environment(null, null, new Vec3(1.4, 1.4, 1.4), Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        return Level.of("wall", "", environment, List.of())
                .with(null, GUN)
                .with(
                        List.of(),
                        List.of(
                                box("wall", new Vec3(0, 2, -0.5), new Vec3(12, 6, 1)),
                                box("floor", new Vec3(0, -0.5, 4), new Vec3(12, 1, 10))));
    }

    private static Solid box(String id, Vec3 centre, Vec3 size) {
        return new Solid.Box(id, null, true, null, centre, size, Map.of());
    }

    private static Portal portal(Vec3 centre) {
        var aperture = Aperture.of(GUN.shape(), GUN.widthMetres(), GUN.heightMetres());
        return new Portal("shot", centre, Portal.facing(new Vec3(0, 0, 1), new Vec3(0, 1, 0)), aperture);
    }

    /** Returns both shots in the wall, linked or not. */
    private static FrameState shots(boolean linked, double openness) {
        FrameState frameState = FrameState.atStart(wall());
        List<Integer> partners = linked ? List.of(1, 0) : List.of(Portals.CLOSED, Portals.CLOSED);
        frameState.portals(new Portals(List.of(portal(LEFT), portal(RIGHT)), partners));
        frameState.setPortalLook(0, 0, openness);
        frameState.setPortalLook(1, 1, openness);
        frameState.seconds(3.3);
        return frameState;
    }

    private static int[] draw(FrameState frameState, Decoration decoration) {
        try (var offscreen = new Offscreen(WIDTH, HEIGHT);
                var renderer = LevelRenderer.load(
                        offscreen.gl,
                        wall(),
                        TestAssets.NONE,
                        RenderSettings.of(Output.DIRECT).with(decoration))) {
            View view = offscreen.view(new Vec3(0, 1.2, EYE_METRES), new Vec3(0, 1.2, 0));
            renderer.draw(view, frameState, offscreen.picture);
            offscreen.gl.requireNoError("rims");
            return offscreen.pixels();
        }
    }

    private static double luma(int rgb) {
        return 0.2126 * Offscreen.red(rgb) + 0.7152 * Offscreen.green(rgb) + 0.0722 * Offscreen.blue(rgb);
    }

    /** Returns the pixel of a point on the rims' luminous strips, 43 mm in front of the wall. */
    private static int pixel(double x, double y) {
        double scale = HEIGHT / 2.0 / (EYE_METRES - 0.043);
        int column = (int) Math.floor(WIDTH / 2.0 + x * scale);
        int row = (int) Math.floor(HEIGHT / 2.0 + (y - 1.2) * scale);
        return row * WIDTH + column;
    }

    /** Fog that hides the wall hides rims, their glow, membranes and outlines. */
    @Test
    void thickFogHidesAFarRim() {
        Level fogged = new TestLevel()
                .fog(3, new Vec3(0.2, 0.4, 0.6))
                .ambient(1)
                .box(null, new Vec3(0, 2, -0.5), new Vec3(12, 6, 1))
                .portal("a", "b", LEFT, new Vec3(0, 0, 1), 1.2, 2.1)
                .portal("b", "a", RIGHT, new Vec3(0, 0, 1), 1.2, 2.1)
                .level();
        FrameState closed = FrameState.atStart(fogged);
        List<Portal> both = List.of(portal(LEFT), portal(RIGHT));
        closed.portals(new Portals(both, List.of(Portals.CLOSED, Portals.CLOSED)));
        for (FrameState frameState : List.of(FrameState.atStart(fogged), closed)) {
            try (var offscreen = new Offscreen(64, 36);
                    var renderer = LevelRenderer.load(
                            offscreen.gl, fogged, TestAssets.NONE, RenderSettings.of(Output.PLAIN))) {
                renderer.draw(offscreen.view(new Vec3(0, 1.2, 4), new Vec3(0, 1.2, 0)), frameState, offscreen.picture);
                for (int rgb : offscreen.pixels()) {
                    assertEquals(0x336699, rgb, "0x" + Integer.toHexString(rgb));
                }
            }
        }
    }

    /** Where a portal stands on the floor, no part of its rim that is under the floor shows through it. */
    @Test
    void nothingShowsThroughTheFloor() {
        FrameState closed = shots(false, 1);
        List<Portal> onFloor = List.of(portal(new Vec3(-1.1, 1.05, 0)), portal(new Vec3(1.1, 1.05, 0)));
        closed.portals(new Portals(onFloor, List.of(Portals.CLOSED, Portals.CLOSED)));
        FrameState preview = shots(false, 0);
        preview.portals(Portals.NONE);
        preview.previews(List.of(
                new FrameState.PortalPreview(onFloor.get(0), 0), new FrameState.PortalPreview(onFloor.get(1), 1)));
        FrameState none = FrameState.atStart(wall());
        try (var offscreen = new Offscreen(WIDTH, HEIGHT);
                var renderer =
                        LevelRenderer.load(offscreen.gl, wall(), TestAssets.NONE, RenderSettings.of(Output.DIRECT))) {
            // Where the eye is in the plane of one of the faces of the lower bar.
            for (double away : new double[] {1.02, 3.48, 3.5, 3.52, 8.74}) {
                View view = offscreen.view(new Vec3(0.3, 1.65, away), new Vec3(0.3, 1.65, 0));
                renderer.draw(view, none, offscreen.picture);
                int[] expected = offscreen.pixels();
                // The floor from the front of the rims on.
                int rows = (int) Math.floor(HEIGHT / 2.0 * (1 - 1.65 / (away - 0.05)));
                for (FrameState frameState : List.of(closed, preview)) {
                    renderer.draw(view, frameState, offscreen.picture);
                    int[] picture = offscreen.pixels();
                    int differ = 0;
                    for (int i = 0; i < (rows - 1) * WIDTH; i++) {
                        differ += picture[i] == expected[i] ? 0 : 1;
                    }
                    assertEquals(0, differ, "from " + away + " m");
                }
            }
        }
    }

    /** In luma, light and dark alternate along the sides of the first rim and not along the second's. */
    @Test
    void thePatternsDifferWithoutColour() {
        int[] picture = draw(shots(true, 1), Decoration.ON);
        double first = spread(picture, LEFT.x() - 0.65);
        double second = spread(picture, RIGHT.x() + 0.65);
        assertTrue(first > 3 * second, first + " and " + second);
    }

    /** Returns the standard deviation of luma along a vertical line. */
    private static double spread(int[] picture, double x) {
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (double y = 0.4; y < 1.5; y += 0.02) {
            double luma = luma(picture[pixel(x, y)]);
            sum += luma;
            squares += luma * luma;
            count++;
        }
        return Math.sqrt(squares / count - sum * sum / count / count);
    }

    @Test
    void eachShotHasItsColour() {
        int[] picture = draw(shots(true, 1), Decoration.ON);
        assertTrue(blueOverRed(picture, LEFT.x() - 0.65) > 40, "the first is blue");
        assertTrue(blueOverRed(picture, RIGHT.x() + 0.65) < -40, "the second is orange");
    }

    private static double blueOverRed(int[] picture, double x) {
        double sum = 0;
        int count = 0;
        for (double y = 0.4; y < 1.5; y += 0.02) {
            int rgb = picture[pixel(x, y)];
            sum += Offscreen.blue(rgb) - Offscreen.red(rgb);
            count++;
        }
        return sum / count;
    }

    /** The membrane of a portal without a partner is neither black nor uniform, and moves. */
    @Test
    void aClosedPortalWhirls() {
        FrameState frameState = shots(false, 1);
        int[] early = draw(frameState, Decoration.ON);
        frameState.seconds(5.3);
        int[] late = draw(frameState, Decoration.ON);
        double least = 255;
        double most = 0;
        int moved = 0;
        for (double x = -0.4; x <= 0.4; x += 0.05) {
            for (double y = -0.8; y <= 0.6; y += 0.05) {
                int at = pixel(LEFT.x() + x, LEFT.y() + y);
                least = Math.min(least, luma(early[at]));
                most = Math.max(most, luma(early[at]));
                moved += Math.abs(luma(early[at]) - luma(late[at])) > 3 ? 1 : 0;
            }
        }
        assertTrue(least > 20, "darkest " + least);
        assertTrue(most - least > 25, least + " to " + most);
        assertTrue(moved > 100, moved + " places moved");
    }

    /** An opening portal grows about its centre: at half its size nothing is outside that and its rim. */
    @Test
    void theRimGrowsWithTheOpening() {
        int[] half = draw(shots(false, 0.5), Decoration.ON);
        int[] none = draw(FrameState.atStart(wall()), Decoration.ON);
        int inside = pixel(LEFT.x() - 0.34, LEFT.y());
        int outside = pixel(LEFT.x() - 0.65, LEFT.y());
        assertTrue(half[inside] != none[inside], "a rim at half the width");
        assertEquals(none[outside], half[outside]);
    }

    @Test
    void aPreviewIsSeenAndThinnerThanARim() {
        FrameState frameState = FrameState.atStart(wall());
        int[] none = draw(frameState, Decoration.ON);
        frameState.previews(List.of(new FrameState.PortalPreview(portal(LEFT), 0)));
        int[] preview = draw(frameState, Decoration.ON);
        int[] rim = draw(shots(false, 1), Decoration.ON);
        assertTrue(differing(none, preview) > 50, "a ghost");
        assertTrue(differing(none, preview) < differing(none, rim) / 3, "less than a rim");
        assertEquals(none[pixel(LEFT.x(), LEFT.y())], preview[pixel(LEFT.x(), LEFT.y())], "no membrane");
    }

    @Test
    void withoutDecorationThereIsNone() {
        int[] none = draw(FrameState.atStart(wall()), Decoration.OFF);
        FrameState frameState = shots(false, 1);
        frameState.previews(List.of(new FrameState.PortalPreview(portal(LEFT), 0)));
        assertArrayEquals(none, draw(frameState, Decoration.OFF));
        assertTrue(differing(none, draw(frameState, Decoration.ON)) > 1000);
    }

    private static int differing(int[] a, int[] b) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            count += a[i] == b[i] ? 0 : 1;
        }
        return count;
    }
}
