package nephele.engine.render.pass.lightning;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
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
            new Lightning(12, 5, new Vec3(0, 1000, -2000), new Vec3(1, 1, 1), 0, 1, new Vec3(2e6, 2e6, 2e6));

    private static final LevelLightning TIMES = new LevelLightning(STORM);
    private static final double FLASH = TIMES.beginSeconds(1) + 0.03;
    private static final double DARK = TIMES.beginSeconds(1) - 0.05;

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private float[] radiance(Level level, View view, double seconds) {
        try (Renderer renderer = Renderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR))) {
            FrameState state = FrameState.atStart(level);
            state.seconds(seconds);
            renderer.draw(view, state, offscreen.picture);
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
        return new TestLevel().ambient(0.1).box(null, new Vec3(0, -0.5, 0), new Vec3(60, 1, 60));
    }

    /** A channel far thinner than a pixel: its light per solid angle falls with the square of the distance. */
    @Test
    void theLightOfABoltDoesNotDependOnItsWidthInPixels() {
        Level level = new TestLevel().lightning(STORM).level();
        Vec3 middle = new Vec3(0, 500, -2000);
        double near = sum(radiance(level, offscreen.view(new Vec3(0, 500, 1500), middle), FLASH));
        double far = sum(radiance(level, offscreen.view(new Vec3(0, 500, 12000), middle), FLASH));
        assertTrue(near > 0);
        assertEquals(near * 3500 * 3500, far * 14000 * 14000, 0.03 * near * 3500 * 3500);
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
        double irradiance = 2e6 * TIMES.brightness() / (2000 * 2000 + 600 * 600 + 250 * 250);
        double ofBolt = irradiance * 600 / Math.hypot(2000, 600) / Math.PI;
        double ofGlow = 0.45 * irradiance / Math.PI;
        assertEquals(ofBolt + ofGlow, more, 0.12 * (ofBolt + ofGlow));
    }

    @Test
    void cloudsAreLitFromInsideAndHideTheBoltBehindThem() {
        TestLevel sky = new TestLevel().lightning(STORM);
        double bolt = sum(radiance(sky.level(), lookingUp(), FLASH));
        Level clouded = sky.cloud(new Vec3(0, 1000, -2000), new Vec3(1600, 900, 1600), 0.02, 1, 0.85)
                .level();
        double dark = sum(radiance(clouded, lookingUp(), DARK));
        double lit = sum(radiance(clouded, lookingUp(), FLASH));
        assertEquals(0, dark, 1e-3);
        Level grey = new TestLevel()
                .lightning(STORM)
                .cloud(new Vec3(0, 1000, -1000), new Vec3(3000, 900, 300), 0.2, 0, 0)
                .level();
        assertTrue(lit > 0.2 * bolt, lit + " of " + bolt);
        assertTrue(sum(radiance(grey, lookingUp(), FLASH)) < 0.02 * bolt, "a black cloud hides the bolt");
    }

    private View lookingUp() {
        return offscreen.view(new Vec3(0, 2, 0), new Vec3(0, 1000, -2000));
    }
}
