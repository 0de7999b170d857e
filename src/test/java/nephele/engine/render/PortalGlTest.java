package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Culling;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Narrowing;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Views through portals are the same with every technique and setting, and the same as through a hole. */
class PortalGlTest {
    private static final Vec3 SHADOW_SUN = new Vec3(1, 1, 0.5);
    private static final Quality QUALITY = Quality.HIGH.inOneFrame().with("viewBudget", 40);

    private static RenderSettings settings(Output output) {
        return RenderSettings.of(output, QUALITY).with(Decoration.OFF);
    }

    /** Returns boxes of many colours all around, some lit by a punctual light, under a sky that is not constant. */
    private static TestLevel furnished(long seed) {
        Random random = new Random(seed);
        TestLevel level = new TestLevel()
                .sun(new Vec3(0.3, 1, 0.5), 2)
                .ambient(0.3)
                .sky(new Sky.Gradient(TestLevel.grey(0.1), TestLevel.grey(0.8), TestLevel.grey(0.3)))
                .light(new Light.Point("lamp", new Vec3(1, 2, 1), TestLevel.grey(5), 9, false));
        for (int i = 0; i < 60; i++) {
            level.material("m" + i, new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble()));
            Vec3 centre = new Vec3(coordinate(random), coordinate(random), coordinate(random));
            Vec3 size = new Vec3(0.2 + random.nextDouble(), 0.2 + random.nextDouble(), 0.2 + random.nextDouble());
            level.box("m" + i, centre, size);
        }
        return level;
    }

    private static double coordinate(Random random) {
        return 16 * random.nextDouble() - 8;
    }

    /** Returns two portals that face each other across the furniture, and two more at an angle. */
    private static Level facing() {
        TestLevel level = furnished(4);
        for (int i = 0; i < 12; i++) {
            level.cube("m" + i, new Vec3(i - 6, Math.sin(i), 3 * Math.cos(2 * i)), 0.5);
        }
        return level.cube("m3", new Vec3(0.5, -0.4, -5.9), 0.6)
                .portal("a", "b", new Vec3(0, 0, -6), new Vec3(0, 0, 1), 4, 4)
                .portal("b", "a", new Vec3(0, 0, 6), new Vec3(0, 0, -1), 4, 4)
                .portal("c", "d", new Vec3(-5, 0, 0), new Vec3(1, 0.2, 0), 3, 3)
                .portal("d", "c", new Vec3(5, -1, 0), new Vec3(-1, 0.3, 0.4), 3, 3)
                .level();
    }

    private static View[] views(Offscreen offscreen) {
        return new View[] {
            offscreen.view(new Vec3(0.3, 0.2, 1), new Vec3(0, 0, -6)),
            offscreen.view(new Vec3(0.3, 0.2, -5.9), new Vec3(0.5, 0.1, -6)),
            offscreen.view(new Vec3(-4.9, 0.4, 0.2), new Vec3(-5, 0, 0.3)),
            offscreen.view(new Vec3(3, 1.2, 2), new Vec3(-5, 0, 0))
        };
    }

    /** Culling and narrowing remove only invisible solids and bodies. */
    @ParameterizedTest
    @EnumSource
    void picturesDoNotDependOnWhatIsLeftOut(Culling culling) {
        try (Offscreen offscreen = new Offscreen(96, 54)) {
            Scene scene = Scene.of(facing(), TestAssets.NONE);
            RenderSettings all = settings(Output.DIRECT).with(Culling.NONE).with(Narrowing.OFF);
            int[][] expected = drawAll(offscreen, scene, all);
            for (Narrowing narrowing : Narrowing.values()) {
                RenderSettings other = settings(Output.DIRECT).with(culling).with(narrowing);
                assertArrayEquals(expected, drawAll(offscreen, scene, other), culling + " " + narrowing);
            }
        }
    }

    /** Separate pictures at full resolution show the same pixels as the stencil, in every output. */
    @ParameterizedTest
    @EnumSource
    void bothTechniquesDrawTheSamePixels(Output output) {
        try (Offscreen offscreen = new Offscreen(96, 54)) {
            Scene scene = Scene.of(facing(), TestAssets.NONE);
            RenderSettings stencil = settings(output);
            RenderSettings texture = stencil.with(QUALITY.with("portalTechnique", PortalTechnique.TEXTURE));
            assertArrayEquals(drawAll(offscreen, scene, stencil), drawAll(offscreen, scene, texture));
        }
    }

    /** In the very first frame, too, dynamic objects cast their current shadows, whichever view is drawn first. */
    @ParameterizedTest
    @EnumSource
    void dynamicObjectsCastShadowsBehindPortals(PortalTechnique technique) {
        try (Offscreen offscreen = new Offscreen(96, 54)) {
            View view = offscreen.view(new Vec3(0, 1.9, 0), new Vec3(0, 0.6, -3));
            int[] shaded = draw(offscreen, shadowBehindAPortal().level(), view, settings(Output.PLAIN));
            int[] unshaded =
                    draw(offscreen, shadowBehindAPortal().sun(SHADOW_SUN, 2).level(), view, settings(Output.PLAIN));
            assertTrue(differing(shaded, unshaded) > 50, "a shadow is seen: " + differing(shaded, unshaded));
            RenderSettings other = settings(Output.PLAIN).with(QUALITY.with("portalTechnique", technique));
            assertArrayEquals(shaded, draw(offscreen, shadowBehindAPortal().level(), view, other));
        }
    }

    private static TestLevel shadowBehindAPortal() {
        return new TestLevel()
                .castingSun(SHADOW_SUN, 2)
                .ambient(0.2)
                .box(null, new Vec3(100, -0.5, 0), new Vec3(20, 1, 20))
                .cube(null, new Vec3(100, 1.8, 3), 1.4)
                .portal("a", "b", new Vec3(0, 1, -2), new Vec3(0, 0, 1), 4, 3)
                .portal("b", "a", new Vec3(100, 1, 0), new Vec3(0, 0, 1), 4, 3);
    }

    /** Draws all views with one renderer, none with history. */
    private static int[][] drawAll(Offscreen offscreen, Scene scene, RenderSettings settings) {
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, scene, settings)) {
            View[] views = views(offscreen);
            int[][] pictures = new int[views.length][];
            for (int i = 0; i < views.length; i++) {
                renderer.forget();
                renderer.draw(views[i], offscreen.picture);
                pictures[i] = offscreen.pixels();
            }
            offscreen.gl.requireNoError("test frames");
            return pictures;
        }
    }

    /** Half the resolution blurs the picture but shows the same content. */
    @Test
    void lessResolutionOnlyBlurs() {
        try (Offscreen offscreen = new Offscreen(160, 90)) {
            View view = views(offscreen)[0];
            Quality half =
                    QUALITY.with("portalTechnique", PortalTechnique.TEXTURE).with("portalResolution", 0.5);
            int[] whole = draw(offscreen, facing(), view, settings(Output.PLAIN));
            int[] blurred =
                    draw(offscreen, facing(), view, settings(Output.PLAIN).with(half));
            double sum = 0;
            for (int i = 0; i < whole.length; i++) {
                sum += Math.abs(Offscreen.green(whole[i]) - Offscreen.green(blurred[i]));
            }
            assertNotEquals(0, sum);
            assertTrue(sum / whole.length < 4, "mean difference " + sum / whole.length + " of 255");
        }
    }

    /** With several samples a pixel, edges in nested views are as smooth as others. */
    @Test
    void samplesAreTakenThroughPortals() {
        try (Offscreen offscreen = new Offscreen(160, 90)) {
            View view = views(offscreen)[0];
            int[] one = draw(offscreen, facing(), view, settings(Output.PLAIN));
            int[] four = draw(offscreen, facing(), view, settings(Output.PLAIN).with(QUALITY.with("samples", 4)));
            double sum = 0;
            for (int i = 0; i < one.length; i++) {
                sum += Math.abs(Offscreen.green(one[i]) - Offscreen.green(four[i]));
            }
            assertNotEquals(0, sum);
            assertTrue(sum / one.length < 6, "mean difference " + sum / one.length + " of 255");
        }
    }

    /**
     * If entry and exit coincide, the view through the portal equals the view past it. The eye comes as near to the
     * plane as 1e-9 m on either side, looking up to 89.99° from the normal, and no pixel differs from the picture
     * without portals, except where an edge is on a pixel's centre.
     */
    @Test
    void throughAPortalThatLeadsNowhereElseNothingChanges() {
        Level open = furnished(9).level();
        Level identity = furnished(9)
                .portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), 3, 3)
                .portal("b", "a", Vec3.ZERO, new Vec3(0, 0, -1), 3, 3)
                .level();
        try (Offscreen offscreen = new Offscreen(160, 90);
                Renderer plain = load(offscreen, open);
                Renderer portals = load(offscreen, identity)) {
            int worst = 0;
            for (double metres : new double[] {1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.1, 1, 3}) {
                for (double degrees : new double[] {0, 30, 60, 85, 89, 89.9, 89.99}) {
                    for (int side = -1; side <= 1; side += 2) {
                        View view = looking(offscreen, side * metres, degrees);
                        plain.draw(view, offscreen.picture);
                        int[] expected = offscreen.pixels();
                        portals.draw(view, offscreen.picture);
                        worst = Math.max(worst, differing(expected, offscreen.pixels()));
                    }
                }
            }
            assertTrue(worst <= 3, worst + " of 14400 pixels");
        }
    }

    private static View looking(Offscreen offscreen, double z, double degrees) {
        double angle = Math.toRadians(degrees);
        Vec3 eye = new Vec3(0.2, -0.3, z);
        return offscreen.view(eye, new Vec3(eye.x() + 9 * Math.sin(angle), eye.y(), eye.z() - 9 * Math.cos(angle)));
    }

    /**
     * A path through two pairs that leads back to its start shows the start: A leads to B, and beside it C leads back
     * to where A is.
     */
    @Test
    void thereAndBackIsWhereItBegan() {
        Vec3 away = new Vec3(300, 0, 0);
        Level open = furnished(11).level();
        // Looking through a from z > 0, the eye is at b, 300 m away, where c in front of the exit leads back behind a.
        Level there = furnished(11)
                .portal("a", "b", new Vec3(0, 0, 1), new Vec3(0, 0, 1), 3, 3)
                .portal("b", "a", new Vec3(away.x(), 0, 1), new Vec3(0, 0, -1), 3, 3)
                .portal("c", "d", new Vec3(away.x(), 0, 0.5), new Vec3(0, 0, 1), 9, 9)
                .portal("d", "c", new Vec3(0, 0, 0.5), new Vec3(0, 0, -1), 9, 9)
                .level();
        try (Offscreen offscreen = new Offscreen(160, 90)) {
            // The space between the planes is empty, so that both levels show the same.
            View view = offscreen.view(new Vec3(0.1, 0.1, 3), new Vec3(0, 0, -5));
            int[] expected = draw(offscreen, cleared(open), view, settings(Output.PLAIN));
            int[] actual = draw(offscreen, cleared(there), view, settings(Output.PLAIN));
            int differing = differing(expected, actual);
            assertTrue(differing <= 20, differing + " of 14400 pixels");
        }
    }

    /** Removes the solids that reach between z = 0.5 and z = 1. */
    private static Level cleared(Level level) {
        var solids = level.solids().stream()
                .map(solid -> (nephele.engine.level.Solid.Box) solid)
                .filter(box -> box.centre().z() + box.size().z() / 2 < 0.5
                        || box.centre().z() - box.size().z() / 2 > 1)
                .map(box -> (nephele.engine.level.Solid) box)
                .toList();
        return level.with(level.materials(), solids);
    }

    /** With a sky that is a clear colour, with or without fog, a nested view is cleared like the picture. */
    @Test
    void aConstantSkyIsSeenThroughAPortal() {
        try (Offscreen offscreen = new Offscreen(32, 18)) {
            Level level = new TestLevel()
                    .sky(new Sky.Constant(new Vec3(0.2, 0.4, 0.8)))
                    .ambient(1)
                    .box(null, new Vec3(0, 0, -1), new Vec3(20, 20, 1))
                    .portal("a", "b", new Vec3(0, 0, -0.5), new Vec3(0, 0, 1), 9, 9)
                    .portal("b", "a", new Vec3(0, 90, 0), new Vec3(0, 1, 0), 9, 9)
                    .level();
            View view = offscreen.view(new Vec3(0, 0, 1), new Vec3(0, 0, -1));
            for (PortalTechnique technique : PortalTechnique.values()) {
                RenderSettings plain = settings(Output.PLAIN).with(QUALITY.with("portalTechnique", technique));
                int[] pixels = draw(offscreen, level, view, plain);
                assertTrue(Arrays.stream(pixels).allMatch(pixel -> pixel == 0x3366cc));
            }
        }
    }

    static int differing(int[] a, int[] b) {
        assertEquals(a.length, b.length);
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            boolean near = Math.abs(Offscreen.red(a[i]) - Offscreen.red(b[i])) <= 1
                    && Math.abs(Offscreen.green(a[i]) - Offscreen.green(b[i])) <= 1
                    && Math.abs(Offscreen.blue(a[i]) - Offscreen.blue(b[i])) <= 1;
            count += near ? 0 : 1;
        }
        return count;
    }

    private static Renderer load(Offscreen offscreen, Level level) {
        return LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings(Output.PLAIN));
    }

    private static int[] draw(Offscreen offscreen, Level level, View view, RenderSettings settings) {
        return offscreen.pixels(level, TestAssets.NONE, view, settings);
    }
}
