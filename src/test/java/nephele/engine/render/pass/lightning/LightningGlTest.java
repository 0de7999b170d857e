package nephele.engine.render.pass.lightning;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment.Lightning;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.lightning.LevelLightning;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Pictures of a strike: its lines have the same light from any distance, and it lights the ground and clouds. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class LightningGlTest {
    private static final int SIZE = 96;

    /** In a box so small that every strike starts at one place; all strike the ground. */
    private static final Lightning STORM =
            new Lightning(12, 5, new Vec3(0, 200, -400), new Vec3(1, 1, 1), 0, 1, new Vec3(8e4, 8e4, 8e4));

    private static final LevelLightning TIMES = new LevelLightning(STORM);
    private static final double FLASH = TIMES.beginSeconds(1) + 0.03;
    private static final double DARK = TIMES.beginSeconds(1) - 0.05;

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);

    private final RenderTarget fourfold =
            RenderTarget.picture(offscreen.gl, "four times as wide", PixelFormat.RGBA8, 4 * SIZE, 4 * SIZE);

    @AfterAll
    void close() {
        fourfold.close();
        offscreen.close();
    }

    private float[] radiance(Level level, View view, double seconds) {
        return radiance(level, view, seconds, offscreen.picture);
    }

    private float[] radiance(Level level, View view, double seconds, RenderTarget picture) {
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR))) {
            FrameState state = FrameState.atStart(level);
            state.seconds(seconds);
            renderer.draw(view, state, picture);
            offscreen.gl.requireNoError("lightning");
            return renderer.readRadiance();
        }
    }

    private static double sum(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum;
    }

    private static TestLevel ground() {
        return new TestLevel()
                .ambient(0.1)
                .material("white", new Vec3(1, 1, 1))
                .box("white", new Vec3(0, -0.5, 0), new Vec3(60, 1, 60));
    }

    /** A channel far thinner than a pixel: its light does not depend on how large the pixels are. */
    @Test
    void theLightOfABoltDoesNotDependOnItsWidthInPixels() {
        Level level = new TestLevel().lightning(STORM).level();
        View view = offscreen.view(new Vec3(0, 100, 100), new Vec3(0, 100, -400));
        double coarse = sum(radiance(level, view, FLASH));
        double fine = sum(radiance(level, view, FLASH, fourfold));
        assertTrue(coarse > 0);
        assertEquals(16 * coarse, fine, 0.02 * fine);
    }

    @Test
    void theGroundIsLitByAFlashAndAsWithoutLightningBetween() {
        Level without = ground().level();
        Level with = ground().lightning(STORM).level();
        View down = offscreen.view(new Vec3(0, 3, 8), new Vec3(0, 0, 2));
        float[] plain = radiance(without, down, DARK);
        assertArrayEquals(plain, radiance(with, down, DARK));
        int middle = 3 * (SIZE / 2 * SIZE + SIZE / 2);
        TIMES.at(FLASH, FlashStyle.NATURAL);
        // A matt white ground under a light of this irradiance and slope, and under the glow of the sky.
        double more = radiance(with, down, FLASH)[middle] - plain[middle];
        double irradiance = 8e4 * TIMES.brightness() / (400 * 400 + 120 * 120 + 50 * 50);
        double ofBolt = irradiance * 120 / Math.hypot(400, 120) / Math.PI;
        double ofGlow = 0.45 * irradiance / Math.PI;
        assertEquals(ofBolt + ofGlow, more, 0.12 * (ofBolt + ofGlow));
    }

    @Test
    void cloudsAreLitFromInsideAndHideTheBoltBehindThem() {
        TestLevel sky = new TestLevel().lightning(STORM);
        double bolt = sum(radiance(sky.level(), lookingUp(), FLASH));
        Level clouded = sky.cloud(new Vec3(0, 200, -400), new Vec3(320, 180, 320), 0.1, 1, 0.85)
                .level();
        double dark = sum(radiance(clouded, lookingUp(), DARK));
        double lit = sum(radiance(clouded, lookingUp(), FLASH));
        assertEquals(0, dark, 1e-3);
        Level grey = new TestLevel()
                .lightning(STORM)
                .cloud(new Vec3(0, 100, -200), new Vec3(1200, 800, 60), 1, 0, 0)
                .level();
        assertTrue(lit > 0.2 * bolt, lit + " of " + bolt);
        assertTrue(sum(radiance(grey, lookingUp(), FLASH)) < 0.02 * bolt, "a black cloud hides the bolt");
    }

    private View lookingUp() {
        return offscreen.view(new Vec3(0, 2, 0), new Vec3(0, 120, -400));
    }
}
