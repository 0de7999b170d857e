package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import java.util.TreeSet;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Portals edge to edge, and more portals than the budget, are drawn correctly. */
class PortalEdgeGlTest {
    private static final int WALL = 0xff0000;
    private static final int GREEN = 0x00ff00;
    private static final int BLUE = 0x0000ff;

    /**
     * Returns a red wall with two openings that overlap by {@code overlap} metres at x = 0: left to green, right to
     * blue.
     */
    private static Level edgeToEdge(double overlap) {
        double half = 1 + overlap / 4;
        return new TestLevel()
                .ambient(1)
                .material("wall", new Vec3(1, 0, 0))
                .material("green", new Vec3(0, 1, 0))
                .material("blue", new Vec3(0, 0, 1))
                .box("wall", new Vec3(0, 0, -0.5), new Vec3(30, 30, 1))
                .box("green", new Vec3(100, 0, -30), new Vec3(700, 700, 1))
                .box("blue", new Vec3(-1000, 0, -30), new Vec3(700, 700, 1))
                .portal("left", "green", new Vec3(-half + overlap / 2, 0, 0), new Vec3(0, 0, 1), 2 * half, 2)
                .portal("right", "blue", new Vec3(half - overlap / 2, 0, 0), new Vec3(0, 0, 1), 2 * half, 2)
                .portal("green", "left", new Vec3(100, 0, -5), new Vec3(0, 0, -1), 2 * half, 2)
                .portal("blue", "right", new Vec3(-1000, 0, -5), new Vec3(0, 0, -1), 2 * half, 2)
                .level();
    }

    /**
     * Coplanar portals that touch, or overlap by a micrometre, leave no wall between them and no z-fighting: every
     * pixel belongs to one of the two, the right one on each side of the line.
     */
    @Test
    void portalsEdgeToEdgeDoNotFight() {
        RenderSettings plain = RenderSettings.of(Output.PLAIN).with(Decoration.OFF);
        try (Offscreen offscreen = new Offscreen(96, 54)) {
            for (double overlap : new double[] {0, 1e-6, -1e-7}) {
                try (Renderer renderer =
                        LevelRenderer.load(offscreen.gl, edgeToEdge(overlap), TestAssets.NONE, plain)) {
                    for (int i = 0; i < 60; i++) {
                        Vec3 eye = new Vec3(0.013 * i - 0.4, 0.007 * i - 0.2, 0.3 + 0.01 * i);
                        renderer.draw(offscreen.view(eye, new Vec3(0.002 * i, 0, -1)), offscreen.picture);
                        assertLine(offscreen, eye, new Vec3(0.002 * i, 0, -1));
                    }
                }
            }
        }
    }

    /** Asserts that the middle row is green, then blue, without other colours within the openings. */
    private static void assertLine(Offscreen offscreen, Vec3 eye, Vec3 target) {
        int[] pixels = offscreen.pixels();
        Set<Integer> colours = new TreeSet<>();
        int width = offscreen.picture.width();
        int middle = offscreen.picture.height() / 2;
        int changes = 0;
        for (int x = 0; x < width; x++) {
            int pixel = pixels[middle * width + x];
            int before = pixels[middle * width + Math.max(x - 1, 0)];
            colours.add(pixel);
            if (pixel != before && pixel != WALL && before != WALL) {
                assertEquals(GREEN, before);
                assertEquals(BLUE, pixel);
                changes++;
            }
            if (pixel == WALL && x > 0 && x < width - 1) {
                boolean between = before != WALL && pixels[middle * width + x + 1] != WALL;
                assertTrue(!between, "the wall shows between them from " + eye + " to " + target);
            }
        }
        assertTrue(Set.of(WALL, GREEN, BLUE).containsAll(colours), colours + " from " + eye + " to " + target);
        assertEquals(1, changes);
    }

    /** 64 visible portals are drawn without an error, as many views as the budget permits. */
    @Test
    void sixtyFourPortalsKeepToTheBudget() {
        TestLevel ring = new TestLevel().ambient(1).box(null, new Vec3(0, -2, 0), new Vec3(40, 1, 40));
        for (int i = 0; i < 64; i++) {
            double angle = Math.PI * (i - 31.5) / 64;
            Vec3 centre = new Vec3(9 * Math.sin(angle), 0, -9 * Math.cos(angle));
            ring.portal("p" + i, "p" + (i ^ 1), centre, new Vec3(-centre.x(), 0, -centre.z()), 0.4, 2);
        }
        try (Offscreen offscreen = new Offscreen(160, 90)) {
            View view = offscreen.view(new Vec3(0, 0, 0), new Vec3(0, 0, -9));
            long before = -1;
            for (int budget : new int[] {0, 4, 12, 64}) {
                RenderSettings settings = RenderSettings.of(Output.PLAIN, Quality.HIGH.with("viewBudget", budget))
                        .with(Decoration.OFF);
                try (Renderer renderer = LevelRenderer.load(offscreen.gl, ring.level(), TestAssets.NONE, settings)) {
                    for (int frame = 0; frame < 3; frame++) {
                        renderer.draw(view, offscreen.picture);
                    }
                    offscreen.gl.requireNoError("64 portals");
                    assertTrue(renderer.viewsDrawn() <= budget, renderer.viewsDrawn() + " views");
                    assertTrue(renderer.viewsDrawn() > before);
                    before = renderer.viewsDrawn();
                }
            }
            assertTrue(before > 30, before + " views");
        }
    }
}
