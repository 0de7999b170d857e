package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Several samples a pixel smooth edges and change nothing else. */
class MultisamplingGlTest {
    private static final int SIZE = 64;

    /**
     * Returns a white square of side 1 seen from a distance of 1.5, the view rolled so that all its edges are inclined.
     */
    private static Level square() {
        return new TestLevel()
                .ambient(1)
                .material("white", TestLevel.grey(1))
                .box("white", new Vec3(0, 0, -0.5), new Vec3(1, 1, 1))
                .level();
    }

    private static View slanted() {
        return View.lookAt(
                new Vec3(0, 0, 1.5),
                Vec3.ZERO,
                new Vec3(0.3, 1, 0),
                new nephele.engine.scene.Projection(Math.PI / 2, 1, 0.05, 1000));
    }

    private static RenderSettings settings(Output output, int samples) {
        return RenderSettings.of(output, Quality.HIGH.with("samples", samples));
    }

    private static int[] drawn(Offscreen offscreen, Output output, int samples) {
        return offscreen.pixels(square(), TestAssets.NONE, slanted(), settings(output, samples));
    }

    private static boolean isBetween(int rgb) {
        return Offscreen.red(rgb) > 8 && Offscreen.red(rgb) < 247;
    }

    /** The covered count is within a quarter of the perimeter; in plain, coverage is stored linearly. */
    @Test
    void slantedEdgesTakeTheirCoverage() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            int[] pixels = drawn(offscreen, Output.PLAIN, 4);
            assertTrue(
                    Arrays.stream(pixels).filter(MultisamplingGlTest::isBetween).count() > 40);
            double count = Arrays.stream(pixels).map(Offscreen::red).sum() / 255.0;
            // 90° of view: SIZE / 2 pixels a unit at distance 1.
            double side = SIZE / 2.0 / 1.5;
            assertEquals(side * side, count, 4 * side / 4);
        }
    }

    /**
     * A ledge narrower than a pixel, under a lamp: at its pixels' centres there is the wall, in whose shadow the ledge is
     * not. The mean of many more pixels tells its light. The driver may draw more samples than requested.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8})
    void thinFacesAreLitWhereTheyAre(int samples) {
        Level ledge = new TestLevel()
                .material("white", TestLevel.grey(0.8))
                .light(new Light.Point("lamp", new Vec3(0, 3, 2), new Vec3(20, 20, 20), 20.0, true))
                .box("white", new Vec3(0, 0, -1), new Vec3(8, 6, 2))
                .box("white", new Vec3(0, -1.5, 0.02), new Vec3(8, 3, 0.04))
                .level();
        View view = View.lookAt(
                new Vec3(1, 2.5, 6),
                new Vec3(-1, 0, 0),
                new Vec3(0, 1, 0),
                new nephele.engine.scene.Projection(Math.PI / 3, 1, 0.05, 1000));
        float[] drawn;
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            drawn = radiance(offscreen, ledge, view, samples);
        }
        float[] exact;
        try (Offscreen offscreen = new Offscreen(8 * SIZE, 8 * SIZE)) {
            exact = radiance(offscreen, ledge, view, 1);
        }
        for (int i = SIZE * SIZE / 4; i < SIZE * SIZE * 3 / 4; i++) {
            double mean = 0;
            for (int k = 0; k < 64; k++) {
                int x = 8 * (i % SIZE) + k % 8;
                int y = 8 * (i / SIZE) + k / 8;
                mean += exact[3 * (8 * SIZE * y + x)] / 64;
            }
            assertTrue(
                    drawn[3 * i] >= 0.8 * mean - 0.01,
                    "pixel " + i % SIZE + ", " + i / SIZE + ": " + drawn[3 * i] + " of " + mean);
        }
    }

    private static float[] radiance(Offscreen offscreen, Level level, View view, int samples) {
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings(Output.HDR, samples))) {
            renderer.draw(view, offscreen.picture);
            return renderer.readRadiance();
        }
    }

    @Test
    void oneSampleIsThePictureWithoutTheSetting() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (Output output : Output.values()) {
                int[] one = drawn(offscreen, output, 1);
                assertArrayEquals(offscreen.pixels(square(), slanted(), output), one);
                assertEquals(
                        0,
                        Arrays.stream(one)
                                .filter(MultisamplingGlTest::isBetween)
                                .count());
            }
        }
    }

    /** Away from edges nothing changes, and direct and hdr stay the same picture. */
    @Test
    void insidesStayAsTheyAre() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            int[] direct = drawn(offscreen, Output.DIRECT, 4);
            int[] hdr = drawn(offscreen, Output.HDR, 4);
            int[] single = drawn(offscreen, Output.DIRECT, 1);
            for (int i = 0; i < direct.length; i++) {
                if (!isBetween(direct[i]) && !isBetween(hdr[i])) {
                    assertEquals(Offscreen.red(direct[i]), Offscreen.red(hdr[i]), 1, "pixel " + i);
                    assertEquals(Offscreen.red(single[i]), Offscreen.red(direct[i]), 1, "pixel " + i);
                }
            }
        }
    }

    @Test
    void theTwinAndAnotherSizeWorkAndNothingStays() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            var before = offscreen.gl.live().counts();
            for (Output output : Output.values()) {
                try (Renderer renderer =
                                LevelRenderer.load(offscreen.gl, square(), TestAssets.NONE, settings(output, 4));
                        RenderTarget other = RenderTarget.picture(offscreen.gl, "other", PixelFormat.RGBA8, 32, 16)) {
                    renderer.draw(slanted(), other);
                    renderer.draw(slanted(), offscreen.picture);
                    int[] expected = offscreen.pixels();
                    try (BareTwin twin = new BareTwin(offscreen.gl, renderer, List.of(slanted()), offscreen.picture)) {
                        offscreen.picture.clear(1, 0, 1);
                        twin.draw(0);
                        assertArrayEquals(expected, offscreen.pixels());
                    }
                    offscreen.gl.requireNoError("multisampled frames");
                }
            }
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    /** Views through portals have as many samples as the surrounding view, with every technique. */
    @Test
    void viewsThroughPortalsAreSampledAsWell() {
        Level level = new TestLevel()
                .ambient(1)
                .material("white", TestLevel.grey(1))
                .box("white", new Vec3(100, 0, -0.5), new Vec3(1, 1, 1))
                .portal("a", "b", new Vec3(0, 0, 1), new Vec3(0, 0, 1), 4, 4)
                .portal("b", "a", new Vec3(100, 0, 1), new Vec3(0, 0, -1), 4, 4)
                .level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (PortalTechnique technique : PortalTechnique.values()) {
                for (int samples : new int[] {1, 4}) {
                    Quality quality = Quality.HIGH.with("samples", samples).with("portalTechnique", technique);
                    RenderSettings settings =
                            RenderSettings.of(Output.PLAIN, quality).with(RenderSettings.Decoration.OFF);
                    int[] pixels = offscreen.pixels(level, TestAssets.NONE, slanted(), settings);
                    long between = Arrays.stream(pixels)
                            .filter(MultisamplingGlTest::isBetween)
                            .count();
                    assertTrue(samples == 1 ? between == 0 : between > 40, technique + ": " + between);
                    double side = SIZE / 2.0 / 1.5;
                    double count = Arrays.stream(pixels).map(Offscreen::red).sum() / 255.0;
                    assertEquals(side * side, count, side);
                }
            }
        }
    }

    /** A target with depth as colour attachment, which is incomplete everywhere, falls back to one sample. */
    @Test
    void anIncompleteTargetFallsBackToOneSample() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            var before = offscreen.gl.live().counts();
            assertNull(RenderTarget.multisampled(offscreen.gl, PixelFormat.DEPTH24, 8, 8, 4));
            try (Multisampling samples = new Multisampling(offscreen.gl, 4, false)) {
                assertSame(offscreen.picture, samples.inPlaceOf(offscreen.picture, PixelFormat.DEPTH24));
                samples.resolve(offscreen.picture);
            }
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    @Test
    void moreSamplesThanThereAreBecomeTheMost() {
        try (Offscreen offscreen = new Offscreen(8, 8);
                Multisampling samples = new Multisampling(offscreen.gl, 16384, false)) {
            assertNotNull(samples.inPlaceOf(offscreen.picture, PixelFormat.RGBA8));
            offscreen.gl.requireNoError("16384 samples");
        }
    }
}
