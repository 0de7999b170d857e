package nephele.engine.render.pass.exit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.ExitCurtain;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Curtains of exits add the integral of their emission to what is behind them, and surfaces hide them. */
class ExitGlTest {
    private static final int SIZE = 48;
    private static final Exit EXIT = new Exit("exit", new Vec3(0, -1, -4), 1, 2.5);
    private static final Vec3 AHEAD = new Vec3(0, 0, -4);

    private static TestLevel level() {
        return new TestLevel().sky(new Sky.Constant(new Vec3(0.05, 0.1, 0.2))).exit(EXIT);
    }

    /** The light alone: the veil between the strands is a decoration. */
    private static final RenderSettings LIGHT = RenderSettings.of(Output.HDR).with(Decoration.OFF);

    private static float[] radiance(Offscreen offscreen, Level level, View view) {
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, LIGHT)) {
            renderer.draw(view, offscreen.picture);
            return renderer.readRadiance();
        }
    }

    /** The veil makes a curtain stand out from a wall as bright as the display's white, in both outputs. */
    @ParameterizedTest
    @EnumSource(
            value = Output.class,
            names = {"HDR", "DIRECT"})
    void theVeilDimsWhatIsBehindTheGaps(Output output) {
        Level white = new TestLevel()
                .sky(new Sky.Constant(new Vec3(1, 1, 1)))
                .exit(EXIT)
                .level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(Vec3.ZERO, AHEAD);
            int[] veiled = offscreen.pixels(white, TestAssets.NONE, view, RenderSettings.of(output));
            int[] bare = offscreen.pixels(
                    white, TestAssets.NONE, view, RenderSettings.of(output).with(Decoration.OFF));
            int dimmed = 0;
            for (int i = 0; i < veiled.length; i++) {
                dimmed += Offscreen.red(bare[i]) - Offscreen.red(veiled[i]) > 60 ? 1 : 0;
            }
            assertTrue(dimmed > 40, dimmed + " pixels");
        }
    }

    /** Without a far plane the sky's distance is a division by zero but for rounding, which depends on the direction. */
    @Test
    void beforeTheSkyACurtainIsSeenFromAllSides() {
        Projection endless = new Projection(Math.PI / 2, 1, 0.1, Double.POSITIVE_INFINITY);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE);
                Renderer renderer = LevelRenderer.load(offscreen.gl, level().level(), TestAssets.NONE, LIGHT)) {
            for (int side = 0; side < 40; side++) {
                Vec3 aside = new Vec3(4 * Math.cos(side), 0.02 * side, 4 * Math.sin(side));
                View view = View.lookAt(AHEAD.plus(aside), AHEAD, new Vec3(0, 1, 0), endless);
                renderer.draw(view, offscreen.picture);
                double brightest = 0;
                for (float value : renderer.readRadiance()) {
                    brightest = Math.max(brightest, value);
                }
                assertTrue(brightest > 0.5, "side " + side + ": " + brightest);
            }
        }
    }

    /** Returns the integral of the emission along a ray in fine steps. */
    private static Vec3 integral(Exit exit, Vec3 eye, Vec3 direction) {
        ExitCurtain curtain = new ExitCurtain(exit, 0);
        Vec3 sum = Vec3.ZERO;
        double step = 0.002;
        for (double metres = step / 2; metres < 12; metres += step) {
            sum = sum.addScaled(step, curtain.emissionPerMetre(eye.addScaled(metres, direction)));
        }
        return sum;
    }

    /** Returns the unit direction through the middle of a pixel of a square view with a field of 90° along −z. */
    private static Vec3 direction(int pixel) {
        double x = (2 * (pixel % SIZE) + 1.0) / SIZE - 1;
        double y = (2 * (pixel / SIZE) + 1.0) / SIZE - 1;
        Vec3 towards = new Vec3(x, y, -1);
        return towards.scaled(1 / towards.length());
    }

    @Test
    void theLightIsTheIntegralOfTheEmission() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (double forward : new double[] {0, 3.6}) {
                Vec3 eye = new Vec3(0, 0, -forward);
                View view = offscreen.view(eye, new Vec3(0, 0, -9));
                float[] rgb = radiance(offscreen, level().level(), view);
                double error = 0;
                double light = 0;
                for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
                    Vec3 expected = integral(EXIT, eye, direction(pixel));
                    error += Math.abs(0.05 + expected.x() - rgb[3 * pixel])
                            + Math.abs(0.2 + expected.z() - rgb[3 * pixel + 2]);
                    light += expected.x() + expected.z();
                }
                assertTrue(light > 50, "light " + light);
                assertTrue(error < 0.06 * light, error + " of " + light);
            }
        }
    }

    /** The exit shines before the night's black sky, 4 km away. */
    @Test
    void theAirDimsTheLight() {
        Exit far = new Exit("exit", new Vec3(0, 0, -4000), 400, 800);
        Vec3 sunBelow = new Vec3(0, -1, 0);
        Level inAir = new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(sunBelow, 1e-9)
                .exit(far)
                .level();
        Level inVacuum = new TestLevel().exit(far).level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = View.lookAt(
                    new Vec3(0, 2, 0),
                    new Vec3(0, 2, -4000),
                    new Vec3(0, 1, 0),
                    new Projection(Math.toRadians(1), 1, 0.05, 1e4));
            float[] dimmed = radiance(offscreen, inAir, view);
            float[] bright = radiance(offscreen, inVacuum, view);
            int middle = 3 * (SIZE * SIZE / 2 + SIZE / 2);
            ClearSky air = new ClearSky(AirTables.of(Air.CLEAR));
            // The nearer and the farther side of the curtain emit the same along the axis.
            Vec3 near = air.along(2, new Vec3(0, 0, -1), sunBelow, 3630).transmittance();
            Vec3 away = air.along(2, new Vec3(0, 0, -1), sunBelow, 4370).transmittance();
            Vec3 mean = near.plus(away).scaled(0.5);
            assertEquals(mean.x(), dimmed[middle] / bright[middle], 0.02);
            assertEquals(mean.z(), dimmed[middle + 2] / bright[middle + 2], 0.02);
            assertTrue(mean.z() < 0.87, "some light is lost");
        }
    }

    /** Output DIRECT decodes and encodes 8 bits; it agrees with tone mapping of the linear sum within two codes. */
    @ParameterizedTest
    @EnumSource(ToneCurve.class)
    void bothOutputsAgree(ToneCurve curve) {
        double exposure = 2;
        Level level = level().toneMapping(curve, 1)
                .exit(new Exit("behind", new Vec3(0.5, -1, -6), 1, 3))
                .level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(Vec3.ZERO, AHEAD);
            int[] direct = offscreen.pixels(
                    level,
                    TestAssets.NONE,
                    view,
                    RenderSettings.of(Output.DIRECT, Quality.HIGH).with(Decoration.OFF));
            float[] linear = radiance(offscreen, level, view);
            for (int i = 0; i < direct.length; i++) {
                double expected = 255 * ToneMapping.displayValue(linear[3 * i], exposure, curve);
                assertEquals(expected, Offscreen.red(direct[i]), 2.1, "pixel " + i);
            }
        }
    }

    @Test
    void surfacesHideTheLight() {
        Level open = level().level();
        Level hidden =
                level().box(null, new Vec3(0, 0, -2), new Vec3(20, 20, 0.1)).level();
        Level bare = new TestLevel()
                .sky(new Sky.Constant(new Vec3(0.05, 0.1, 0.2)))
                .box(null, new Vec3(0, 0, -2), new Vec3(20, 20, 0.1))
                .level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(Vec3.ZERO, AHEAD);
            List<Output> outputs = List.of(Output.HDR, Output.DIRECT);
            for (Output output : outputs) {
                RenderSettings settings =
                        RenderSettings.of(output, Quality.HIGH).with(Decoration.OFF);
                int[] seen = offscreen.pixels(open, TestAssets.NONE, view, settings);
                assertTrue(Offscreen.red(seen[SIZE * SIZE / 2 + SIZE / 2]) > 100);
                assertArrayEquals(
                        offscreen.pixels(bare, TestAssets.NONE, view, settings),
                        offscreen.pixels(hidden, TestAssets.NONE, view, settings));
            }
        }
    }

    /** A view away from the exit is the same as that of the level without it. */
    @Test
    void anExitOutsideTheViewChangesNothing() {
        Level without =
                new TestLevel().sky(new Sky.Constant(new Vec3(0.05, 0.1, 0.2))).level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, 4));
            RenderSettings settings = RenderSettings.of(Output.DIRECT, Quality.HIGH);
            assertArrayEquals(
                    offscreen.pixels(without, TestAssets.NONE, view, settings),
                    offscreen.pixels(level().level(), TestAssets.NONE, view, settings));
        }
    }
}
