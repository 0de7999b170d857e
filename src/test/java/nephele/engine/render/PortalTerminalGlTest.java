package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Openings beyond the view budget show history or a membrane. */
class PortalTerminalGlTest {
    /** {@link nephele.engine.render.frame.NestedViews#MARK} as a pixel. */
    private static final int MARK = 0xff00ff;

    private static final int WIDTH = 192;
    private static final int HEIGHT = 108;
    private static final Vec3 WALL = new Vec3(0.9, 0.1, 0.1);
    private static final int WALL_PIXEL = 0xe61a1a;
    private static final int MAGENTA = 0xff00ff;

    /**
     * Returns a closed corridor of eight metres, red at both ends, where an arch faces an arch; side walls, floor and
     * ceiling all differ.
     */
    private static Level corridor() {
        return corridor(4);
    }

    private static Level corridor(double half) {
        return new TestLevel()
                .ambient(1)
                .sky(new Sky.Constant(new Vec3(1, 0, 1)))
                .material("wall", WALL)
                .material("left", new Vec3(0.2, 0.7, 0.3))
                .material("right", new Vec3(0.2, 0.3, 0.8))
                .material("floor", new Vec3(0.5, 0.5, 0.4))
                .material("ceiling", new Vec3(0.9, 0.9, 0.8))
                .box("wall", new Vec3(0, 0, -half - 0.5), new Vec3(8, 8, 1))
                .box("wall", new Vec3(0, 0, half + 0.5), new Vec3(8, 8, 1))
                .box("left", new Vec3(-2.5, 0, 0), new Vec3(1, 8, 8))
                .box("right", new Vec3(2.5, 0, 0), new Vec3(1, 8, 8))
                .box("floor", new Vec3(0, -2, 0), new Vec3(4, 1, 8))
                .box("ceiling", new Vec3(0, 2, 0), new Vec3(4, 1, 8))
                .portal(arch("a", "b", new Vec3(0, -0.3, -half), new Vec3(0, 0, 1)))
                .portal(arch("b", "a", new Vec3(0, -0.3, half), new Vec3(0, 0, -1)))
                .level();
    }

    private static PortalSpec arch(String id, String linkedTo, Vec3 centre, Vec3 normal) {
        return new PortalSpec(id, linkedTo, centre, normal, new Vec3(0, 1, 0), 1.6, 2.2, PortalShape.ARCH);
    }

    private static RenderSettings budget(int views) {
        return RenderSettings.of(Output.PLAIN, Quality.HIGH.with("viewBudget", views))
                .with(Decoration.OFF);
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(0.2, 0.1, -0.5), new Vec3(0, -0.2, -4));
    }

    private static int[] frames(Offscreen offscreen, RenderSettings settings, int count) {
        return frames(offscreen, corridor(), settings, count);
    }

    private static int[] frames(Offscreen offscreen, Level level, RenderSettings settings, int count) {
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            for (int i = 0; i < count; i++) {
                renderer.draw(view(offscreen), offscreen.picture);
            }
            offscreen.gl.requireNoError("frames");
            return offscreen.pixels();
        }
    }

    /** The first frame is complete; only the deepest opening shows a membrane instead of a view. */
    @Test
    void theFirstFrameIsFullyDrawn() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] whole = frames(offscreen, budget(60), 1);
            int[] marked = frames(offscreen, budget(3).with(Deepest.MARK), 1);
            for (PortalTechnique technique : PortalTechnique.values()) {
                RenderSettings few = budget(3);
                int[] first = frames(offscreen, few.with(few.quality().with("portalTechnique", technique)), 1);
                int differing = 0;
                for (int i = 0; i < whole.length; i++) {
                    assertTrue(first[i] != 0 && first[i] != MAGENTA);
                    if (marked[i] == MARK) {
                        assertTrue(first[i] != WALL_PIXEL, "the wall behind an opening");
                        differing++;
                    } else {
                        assertEquals(whole[i], first[i]);
                    }
                }
                assertTrue(differing > 0 && differing < whole.length / 100, differing + " pixels");
            }
        }
    }

    /**
     * An opening whose view is not drawn shows its sky, half hidden by the membrane: half of a change of the sky is
     * visible.
     */
    @Test
    void anOpeningThatNothingFillsShowsTheSkyThere() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] marked = frames(offscreen, underSky(0.2, 0.8), budget(0).with(Deepest.MARK), 1);
            for (PortalTechnique technique : PortalTechnique.values()) {
                RenderSettings none = budget(0);
                RenderSettings settings = none.with(none.quality().with("portalTechnique", technique));
                int[] one = frames(offscreen, underSky(0.2, 0.8), settings, 1);
                int[] other = frames(offscreen, underSky(0.6, 0.8), settings, 1);
                int inside = 0;
                for (int i = 0; i < marked.length; i++) {
                    boolean isOpening = marked[i] == MARK;
                    // Ahead through the opening is up.
                    double more = isOpening ? 255 * 0.5 * 0.4 * ahead(view(offscreen), i) : 0;
                    assertEquals(more, red(other[i]) - red(one[i]), 1.01, technique + ", pixel " + i);
                    inside += isOpening ? 1 : 0;
                }
                assertTrue(inside > 100, inside + " pixels");
            }
        }
    }

    /** Returns the cosine between a pixel's direction and −z. */
    private static double ahead(View view, int pixel) {
        double x = view.projection().tanHalfWidth() * (2 * (pixel % WIDTH + 0.5) / WIDTH - 1);
        double y = view.projection().tanHalfHeight() * (2 * (pixel / WIDTH + 0.5) / HEIGHT - 1);
        double z = x * view.right().z() + y * view.up().z() - view.back().z();
        return -z / Math.sqrt(1 + x * x + y * y);
    }

    /** Returns a wall ahead, with a portal that leads out of a floor far below. */
    private static Level underSky(double zenith, double horizon) {
        return new TestLevel()
                .ambient(1)
                .sky(new Sky.Gradient(TestLevel.grey(zenith), TestLevel.grey(horizon), TestLevel.grey(horizon)))
                .box("wall", new Vec3(0, 0, -4.5), new Vec3(60, 60, 1))
                .material("wall", WALL)
                .portal(arch("a", "b", new Vec3(0, -0.3, -4), new Vec3(0, 0, 1)))
                .box("wall", new Vec3(0, -40, 0), new Vec3(8, 1, 8))
                .portal(new PortalSpec(
                        "b",
                        "a",
                        new Vec3(0, -39.5, 0),
                        new Vec3(0, 1, 0),
                        new Vec3(0, 0, -1),
                        1.6,
                        2.2,
                        PortalShape.ARCH))
                .level();
    }

    private static int red(int pixel) {
        return pixel >> 16 & 0xff;
    }

    /** The opening never shows the wall, black, or a single colour, with or without rims. */
    @Test
    void anOpeningThatNothingFillsIsNeverFlat() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] marked = frames(offscreen, budget(0).with(Deepest.MARK), 1);
            int[] bare = frames(offscreen, budget(0), 1);
            int[] rimmed = frames(offscreen, budget(0).with(Decoration.ON), 1);
            Map<Integer, Integer> counts = new HashMap<>();
            int inside = 0;
            int alike = 0;
            for (int i = 0; i < marked.length; i++) {
                if (marked[i] == MARK) {
                    assertTrue(bare[i] != WALL_PIXEL && bare[i] != 0 && bare[i] != MAGENTA);
                    counts.merge(bare[i], 1, Integer::sum);
                    alike += rimmed[i] == bare[i] ? 1 : 0;
                    inside++;
                }
            }
            int most = counts.values().stream().max(Integer::compare).orElseThrow();
            assertTrue(counts.size() > 100 && most < inside / 10, counts.size() + " colours, " + most + " of one");
            assertTrue(alike > 0.8 * inside, alike + " of " + inside + " as between rims");
        }
    }

    /** With each frame the history goes one level deeper; it approaches the picture of an unlimited budget. */
    @Test
    void historyContinuesWhereTheBudgetEnds() {
        try (Offscreen offscreen = new Offscreen(2 * WIDTH, 2 * HEIGHT)) {
            int[] whole = frames(offscreen, corridor(1.5), budget(60), 1);
            int before = PortalGlTest.differing(whole, frames(offscreen, corridor(1.5), budget(2), 1));
            int after = PortalGlTest.differing(whole, frames(offscreen, corridor(1.5), budget(2), 20));
            assertTrue(before > 30, before + " pixels");
            assertTrue(after < 0.8 * before, after + " of " + before + " pixels");
        }
    }

    /** The terminal opening has the shape of the portal, not a bounding box or an oval. */
    @Test
    void aTerminalOpeningHasTheRightShape() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] marked = frames(offscreen, budget(0).with(Deepest.MARK), 1);
            int[] through = frames(offscreen, budget(60), 1);
            int[] closed = frames(offscreen, budget(0), 1);
            for (int i = 0; i < marked.length; i++) {
                boolean isOpening = marked[i] == MARK;
                assertEquals(isOpening ? MARK : closed[i], marked[i]);
                assertTrue(isOpening || through[i] == closed[i]);
            }
            long opening = Arrays.stream(marked).filter(pixel -> pixel == MARK).count();
            // 1.6 m × 1.4 m and half a disc, at 3.5 m, slightly turned: the arch's share of the picture.
            double share = (1.6 * 1.4 + Math.PI * 0.8 * 0.8 / 2) / Math.pow(2 * 3.5, 2) / (WIDTH / (double) HEIGHT);
            assertEquals(share, opening / (double) marked.length, 0.02 * share + 0.001);
        }
    }

    /** After a cut nothing of the old picture remains. */
    @Test
    void aCutForgetsThePictureBefore() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = LevelRenderer.load(offscreen.gl, corridor(), TestAssets.NONE, budget(2))) {
            renderer.draw(view(offscreen), offscreen.picture);
            int[] first = offscreen.pixels();
            for (int i = 0; i < 4; i++) {
                renderer.draw(view(offscreen), offscreen.picture);
            }
            assertTrue(PortalGlTest.differing(first, offscreen.pixels()) > 0);
            renderer.forget();
            renderer.draw(view(offscreen), offscreen.picture);
            assertArrayEquals(first, offscreen.pixels());
        }
    }

    /** After a step through the portal, the deep views stay visible from the first frame on. */
    @Test
    void historyGoesOnAcrossAPortal() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            View before = offscreen.view(new Vec3(0.1, 0.1, -1.49), new Vec3(0, 0, -9));
            View after = offscreen.view(new Vec3(0.1, 0.1, 1.49), new Vec3(0, 0, -6));
            int[] whole;
            int[] crossed;
            int[] fresh;
            try (Renderer renderer = LevelRenderer.load(offscreen.gl, corridor(1.5), TestAssets.NONE, budget(60))) {
                renderer.draw(after, offscreen.picture);
                whole = offscreen.pixels();
            }
            try (Renderer renderer = LevelRenderer.load(offscreen.gl, corridor(1.5), TestAssets.NONE, budget(2))) {
                renderer.draw(after, offscreen.picture);
                fresh = offscreen.pixels();
                renderer.forget();
                for (int i = 0; i < 6; i++) {
                    renderer.draw(before, offscreen.picture);
                }
                renderer.draw(after, offscreen.picture);
                crossed = offscreen.pixels();
            }
            int withHistory = PortalGlTest.differing(whole, crossed);
            int without = PortalGlTest.differing(whole, fresh);
            assertTrue(without > 20 && withHistory < 0.7 * without, withHistory + " of " + without + " pixels");
        }
    }

    /** Only colours of the corridor appear: a looked-up pixel is inside the opening. */
    @Test
    void lookedUpPixelsAreThoseOfTheCorridor() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            Set<Integer> known =
                    Arrays.stream(frames(offscreen, budget(60), 1)).boxed().collect(Collectors.toSet());
            int[] looked = frames(offscreen, budget(2), 8);
            long blended = Arrays.stream(looked)
                    .filter(pixel -> !known.contains(pixel))
                    .count();
            // Bilinear lookups blend where colours meet.
            assertTrue(blended < looked.length / 200, blended + " pixels");
        }
    }
}
