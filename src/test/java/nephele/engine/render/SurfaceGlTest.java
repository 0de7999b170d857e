package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Solids look as derived in double precision. */
class SurfaceGlTest {
    private static final int SIZE = 96;

    @Test
    void lambertReflectsAlbedoOverPiTimesIrradianceTimesCosine() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            for (double degrees : new double[] {0, 30, 60, 89, 90, 120}) {
                double angle = Math.toRadians(degrees);
                Level level = new TestLevel()
                        .sun(new Vec3(Math.sin(angle), Math.cos(angle), 0), 2)
                        .ambient(0.1)
                        .material("m", new Vec3(0.8, 0.4, 0.2))
                        .box("m", new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                        .level();
                float[] rgb = offscreen.radiance(level, TestAssets.NONE, down(offscreen));
                double factor = Math.max(0, Math.cos(angle)) * 2 / Math.PI + 0.1;
                for (int i = 0; i < rgb.length; i++) {
                    double expected = factor * (i % 3 == 0 ? 0.8 : i % 3 == 1 ? 0.4 : 0.2);
                    assertEquals(expected, rgb[i], expected * 0x1p-10, "at " + degrees + " degrees");
                }
            }
        }
    }

    private static View down(Offscreen offscreen) {
        return offscreen.view(new Vec3(0, 2, 0), new Vec3(0, 0, 0));
    }

    /** A white room under radiance 1 from all directions shows radiance 1 everywhere. */
    @Test
    void aWhiteFurnaceIsWhite() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Level level = new TestLevel()
                    .ambient(1)
                    .sky(new Sky.Constant(TestLevel.grey(1)))
                    .material("white", TestLevel.grey(1))
                    .box("white", new Vec3(0.3, -0.2, 0), new Vec3(1, 1, 1))
                    .level();
            View view = offscreen.view(new Vec3(1.5, 1, 2), Vec3.ZERO);
            for (Output output : Output.values()) {
                int[] pixels = offscreen.pixels(level, view, output);
                assertTrue(Arrays.stream(pixels).allMatch(p -> p == 0xffffff), output.toString());
            }
        }
    }

    /** |count − area| is at most the outline's length in pixels. */
    @Test
    void aSquareCoversItsArea() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            Level level = new TestLevel()
                    .material("m", TestLevel.grey(1))
                    .ambient(1)
                    .box("m", new Vec3(0.13, 0.07, -5.5), new Vec3(3, 2, 1))
                    .level();
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
            long count = Arrays.stream(offscreen.pixels(level, view, Output.PLAIN))
                    .filter(p -> p != 0)
                    .count();
            double pixelsPerMetre = SIZE / (2 * 5.0);
            double area = 3 * 2 * pixelsPerMetre * pixelsPerMetre;
            double outline = 2 * (3 + 2) * pixelsPerMetre;
            assertEquals(area, count, outline);
        }
    }

    /** Linearised depth is the distance along the view within two depth quanta. */
    @Test
    void depthIsTheDistanceAlongTheView() {
        try (Offscreen offscreen = new Offscreen(9, 9)) {
            double near = 0.05;
            double far = 1000;
            for (double distance : new double[] {0.1, 1, 10, 100, 900}) {
                Level level = new TestLevel()
                        .box(null, new Vec3(0, 0, -distance - 50), new Vec3(4000, 4000, 100))
                        .level();
                offscreen.pixels(level, offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1)), Output.PLAIN);
                double depth = offscreen.picture.readDepth()[40];
                double linear = 2 * far * near / (far + near - (2 * depth - 1) * (far - near));
                double quantum = distance * distance * (far - near) / (far * near) * 0x1p-24;
                assertEquals(distance, linear, 2 * quantum, "at " + distance + " m");
            }
        }
    }

    /** Surfaces two depth quanta apart never show the farther one, in any order of drawing. */
    @Test
    void surfacesTwoQuantaApartNeverFlicker() {
        try (Offscreen offscreen = new Offscreen(64, 64)) {
            Projection projection = new Projection(Math.toRadians(60), 1, 0.05, 1000);
            for (double distance : new double[] {1, 10, 100}) {
                double gap = 2 * distance * distance / 0.05 * 0x1p-24;
                for (boolean nearFirst : new boolean[] {true, false}) {
                    assertOnlyTheNearWallIsSeen(offscreen, twoWalls(distance, gap, nearFirst), projection);
                }
            }
        }
    }

    private static void assertOnlyTheNearWallIsSeen(Offscreen offscreen, Level walls, Projection projection) {
        RenderSettings plain = RenderSettings.of(Output.PLAIN);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, walls, TestAssets.NONE, plain)) {
            for (int step = 0; step < 12; step++) {
                Vec3 eye = new Vec3(0.37 * step, 0.21 * step, 0.001 * step);
                Vec3 up = new Vec3(0.1 * step, 1, 0);
                renderer.draw(View.lookAt(eye, new Vec3(eye.x(), eye.y(), -1000), up, projection), offscreen.picture);
                assertTrue(
                        Arrays.stream(offscreen.pixels()).allMatch(p -> p == 0xff0000),
                        walls.solids() + ", step " + step);
            }
        }
    }

    private static Level twoWalls(double distance, double gap, boolean nearFirst) {
        TestLevel level =
                new TestLevel().ambient(1).material("red", new Vec3(1, 0, 0)).material("green", new Vec3(0, 1, 0));
        Vec3 size = new Vec3(2000, 2000, 64);
        Vec3 near = new Vec3(0, 0, -distance - 32);
        Vec3 far = new Vec3(0, 0, -distance - gap - 32);
        return nearFirst
                ? level.box("red", near, size).box("green", far, size).level()
                : level.box("green", far, size).box("red", near, size).level();
    }

    /** Faces have one side: from inside, a solid is invisible. */
    @Test
    void anEyeInsideASolidSeesThroughIt() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            Level level = new TestLevel()
                    .ambient(1)
                    .sky(new Sky.Constant(new Vec3(0, 0, 1)))
                    .box(null, Vec3.ZERO, TestLevel.grey(4))
                    .level();
            int[] pixels = offscreen.pixels(level, offscreen.view(Vec3.ZERO, new Vec3(1, 1, 0)), Output.PLAIN);
            assertTrue(Arrays.stream(pixels).allMatch(p -> p == 0x0000ff));
        }
    }

    @Test
    void emissionIsAddedToReflection() {
        try (Offscreen offscreen = new Offscreen(4, 4)) {
            var shining = new nephele.engine.level.Material(
                    "m", TestLevel.grey(0.5), null, null, null, null, new Vec3(0.25, 0, 2), 1);
            Level level = new TestLevel()
                    .ambient(0.5)
                    .material(shining)
                    .box("m", new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                    .level();
            float[] rgb = offscreen.radiance(level, TestAssets.NONE, down(offscreen));
            assertArrayEquals(new float[] {0.5f, 0.25f, 2.25f}, Arrays.copyOf(rgb, 3));
        }
    }

    /** An sRGB texel drawn direct under light 1 keeps its value; half a code for llvmpipe's approximate decoding. */
    @Test
    void texturesAreDecodedAndEncodedOnce() {
        try (Offscreen offscreen = new Offscreen(64, 64)) {
            TestAssets assets = new TestAssets().picture("grey.png", 4, 4, (x, y) -> 0xbc4010);
            Level level = new TestLevel()
                    .ambient(1)
                    .textured("m", "grey.png")
                    .box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40))
                    .level();
            float[] linear = offscreen.radiance(level, assets, down(offscreen));
            assertEquals(ToneMapping.decodeSrgb(0xbc / 255.0), linear[0], 1e-3);
            int[] direct = offscreen.pixels(level, assets, down(offscreen), RenderSettings.of(Output.DIRECT));
            assertEquals(
                    0xbc, Arrays.stream(direct).map(Offscreen::red).average().orElse(0), 0.5);
            assertEquals(
                    0x10, Arrays.stream(direct).map(Offscreen::blue).average().orElse(0), 0.5);
            int[] plain = offscreen.pixels(level, assets, down(offscreen), RenderSettings.of(Output.PLAIN));
            assertTrue(Arrays.stream(plain).allMatch(p -> p == 0xbc4010));
        }
    }
}
