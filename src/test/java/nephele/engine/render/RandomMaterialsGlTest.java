package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** For any materials and lights, every pixel is a number, not negative, and below the largest half. */
class RandomMaterialsGlTest {
    private static final double[] EXTREMES = {0, 1e-30, 1e-7, 0.5, 1, 1, 1e3, 1e9};

    @Test
    void noPixelOfTheLinearPictureIsNotANumber() {
        Random random = new Random(43);
        try (Offscreen offscreen = new Offscreen(48, 48)) {
            for (int round = 0; round < 8; round++) {
                float[] rgb = offscreen.radiance(level(random).level(), TestAssets.NONE, view(offscreen));
                assertNumbers(rgb, 65504, round);
            }
        }
    }

    /** In output PLAIN into floats, no clamp hides the result of the surface shader. */
    @Test
    void noSurfaceComputesWhatIsNotANumber() {
        Random random = new Random(44);
        try (Offscreen offscreen = new Offscreen(48, 48);
                RenderTarget floats = RenderTarget.picture(offscreen.gl, "floats", PixelFormat.RGBA32F, 48, 48)) {
            for (int round = 0; round < 8; round++) {
                RenderSettings plain = RenderSettings.of(Output.PLAIN);
                try (Renderer renderer =
                        LevelRenderer.load(offscreen.gl, level(random).level(), TestAssets.NONE, plain)) {
                    renderer.draw(view(offscreen), floats);
                    assertNumbers(floats.readFloats(), Float.MAX_VALUE, round);
                }
            }
        }
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(0, 1.5, 3), Vec3.ZERO);
    }

    private static void assertNumbers(float[] rgb, float most, int round) {
        for (float value : rgb) {
            assertTrue(value >= 0 && value <= most, "round " + round + ": " + value);
        }
    }

    private static TestLevel level(Random random) {
        TestLevel level = new TestLevel()
                .sun(new Vec3(random.nextGaussian(), random.nextDouble(), random.nextGaussian()), extreme(random))
                .ambient(extreme(random))
                .sky(new Sky.Gradient(colour(random), colour(random), colour(random)));
        for (int i = 0; i < 8; i++) {
            Double roughness = random.nextInt(4) == 0 ? null : (double) random.nextInt(3) / 2;
            Double metallic = roughness == null ? null : (double) random.nextInt(3) / 2;
            Vec3 base = new Vec3(random.nextInt(3) / 2.0, random.nextInt(3) / 2.0, random.nextInt(3) / 2.0);
            Vec3 emission = random.nextBoolean() ? Vec3.ZERO : colour(random);
            level.material(new Material("m" + i, base, null, roughness, metallic, null, emission, 1));
            level.box("m" + i, new Vec3(i % 4 - 1.5, i / 4 - 0.5, -i % 3), new Vec3(0.8, 0.8, 0.8));
        }
        for (int i = 0; i < 3; i++) {
            Vec3 position = new Vec3(random.nextGaussian(), 0.5 * i, random.nextGaussian());
            double range = i == 0 ? 1e-6 : 1 + 100 * random.nextDouble();
            level.light(new Light.Point("l" + i, position, colour(random), range, false));
        }
        return level;
    }

    private static Vec3 colour(Random random) {
        return new Vec3(extreme(random), extreme(random), extreme(random));
    }

    private static double extreme(Random random) {
        return EXTREMES[random.nextInt(EXTREMES.length)];
    }
}
