package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.PixelRectangle;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;
import org.junit.jupiter.api.Test;

/**
 * Portals that face each other at any distance, and portals that intersect each other, are drawn. Views are limited and
 * scissored, end below one pixel and before a stencil of eight bits overflows, and the last level is filled.
 */
class PortalExtremesGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    private static final int MOST_NESTED = 255;
    private static final int UNLIMITED = 100_000;
    /** Only the sky, which the closed room hides, has this colour. */
    private static final Vec3 LEAK = new Vec3(1, 0, 1);

    /** Returns a closed room, {@code apart} metres from a portal at its end to the one that faces it. */
    private static TestLevel room(double apart) {
        double half = apart / 2;
        return new TestLevel()
                .ambient(1)
                .sky(new Sky.Constant(LEAK))
                .material("end", new Vec3(0.9, 0.1, 0.1))
                .material("side", new Vec3(0.2, 0.6, 0.3))
                .box("end", new Vec3(0, 0, -half - 0.5), new Vec3(8, 8, 1))
                .box("end", new Vec3(0, 0, half + 0.5), new Vec3(8, 8, 1))
                .box("side", new Vec3(-2.5, 0, 0), new Vec3(1, 8, apart))
                .box("side", new Vec3(2.5, 0, 0), new Vec3(1, 8, apart))
                .box("side", new Vec3(0, -2, 0), new Vec3(4, 1, apart))
                .box("side", new Vec3(0, 2, 0), new Vec3(4, 1, apart));
    }

    private static Level facing(double apart) {
        return room(apart)
                .portal("a", "b", new Vec3(0, 0, -apart / 2), new Vec3(0, 0, 1), 1.6, 2)
                .portal("b", "a", new Vec3(0, 0, apart / 2), new Vec3(0, 0, -1), 1.6, 2)
                .level();
    }

    /** Returns openings in free space that cross each other, in front of one in the wall that they overlap. */
    private static Level inside() {
        return room(6).portal("a", "b", new Vec3(-0.4, 0, -2.1), new Vec3(0, 0, 1), 1.6, 2)
                .portal("b", "a", new Vec3(-0.4, 0, 3), new Vec3(0, 0, -1), 1.6, 2)
                .portal("c", "d", new Vec3(0.4, 0.2, -3), new Vec3(0, 0, 1), 1.2, 1.2)
                .portal("d", "c", new Vec3(0.2, 0, -2.1), new Vec3(1, 0, 0), 1.6, 2)
                .level();
    }

    private static ViewTree grown(Level level, View view, int budget) {
        ViewTree tree = new ViewTree(List.of());
        tree.build(view, FrameState.atStart(level), WIDTH, HEIGHT, budget);
        return tree;
    }

    private static void assertBounded(ViewTree tree, int budget) {
        assertTrue(tree.views().size() <= budget + 1, tree.views().size() + " views");
        for (ViewNode node : tree.views().subList(1, tree.views().size())) {
            assertTrue(node.depth() < MOST_NESTED, "so deep: " + node.depth());
            assertTrue(node.area() >= 1, "less than a pixel: " + node.area());
            PixelRectangle own = node.pixels();
            PixelRectangle around = node.parent().pixels();
            assertTrue(own.x() >= around.x() && own.x() + own.width() <= around.x() + around.width());
            assertTrue(own.y() >= around.y() && own.y() + own.height() <= around.y() + around.height());
        }
        for (ViewNode node : tree.terminals()) {
            assertTrue(node.depth() <= MOST_NESTED, "so deep: " + node.depth());
        }
    }

    private static void assertFilled(Offscreen offscreen, Level level, View view, int budget) {
        for (PortalTechnique technique : PortalTechnique.values()) {
            Quality quality = Quality.HIGH.with("viewBudget", budget).with("portalTechnique", technique);
            RenderSettings settings = RenderSettings.of(Output.PLAIN, quality).with(Decoration.OFF);
            try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
                for (int frame = 0; frame < 3; frame++) {
                    renderer.draw(view, offscreen.picture);
                    offscreen.gl.requireNoError("frame");
                    long leaks = Arrays.stream(offscreen.pixels())
                            .filter(pixel -> pixel == 0xff00ff || pixel == 0)
                            .count();
                    assertEquals(0, leaks, technique + ", frame " + frame);
                    assertTrue(renderer.viewsDrawn() <= budget);
                }
            }
        }
    }

    /** Far apart, views end below one pixel; close together, at the greatest depth of the stencil. */
    @Test
    void portalsThatFaceEachOther() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (double apart : new double[] {10, 1, 0.1, 0.002}) {
                Level level = facing(apart);
                View view = offscreen.view(new Vec3(0.1, 0.1, 0.1 * apart), new Vec3(0, 0, -20));
                ViewTree all = grown(level, view, UNLIMITED);
                assertBounded(all, MOST_NESTED);
                assertEquals(apart < 0.5, !all.terminals().isEmpty(), apart + " m apart");
                // The last opening shows its wall, which must be beyond the near plane.
                int least = apart < 0.01 ? 100 : apart < 1 ? 3 : 0;
                assertBounded(grown(level, view, least), least);
                assertFilled(offscreen, level, view, least);
            }
            assertFilled(offscreen, facing(0.002), offscreen.view(Vec3.ZERO, new Vec3(0, 0, -20)), 300);
        }
    }

    /** For any overlaps and crossings of portals, the budget holds and every pixel belongs to the room. */
    @Test
    void portalsInsideEachOther() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (Vec3 eye : new Vec3[] {new Vec3(0.3, 0.1, 1), new Vec3(1.2, 0.3, -2), new Vec3(0.21, 0, -2.5)}) {
                View view = offscreen.view(eye, new Vec3(0, 0, -3));
                for (int budget : new int[] {0, 2, 12, 60}) {
                    assertBounded(grown(inside(), view, budget), budget);
                }
                assertFilled(offscreen, inside(), view, 12);
            }
        }
    }
}
