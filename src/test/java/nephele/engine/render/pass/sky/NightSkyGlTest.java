package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.BiFunction;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The drawn sky of a night against the oracle's: moonlit air, glow, the planet's ground lit by both, moon and stars. */
class NightSkyGlTest {
    private static final int FULL_MOON_DAY = 20;
    private static final List<Vec3> DIRECTIONS = List.of(
            new Vec3(1, 0.2, 0),
            new Vec3(-1, 0.2, 0),
            new Vec3(0.01, 1, 0.01),
            new Vec3(0.01, -1, 0.01),
            new Vec3(0, 0.02, 1),
            new Vec3(0, 0.02, -1),
            new Vec3(1, -0.3, -1),
            new Vec3(0, -0.05, -1));

    private static final int SIDE = 96;
    private static final View STARS = narrow(new Vec3(0.3, 1, 0.2), Math.toRadians(25));

    /** Radiance of starlight that is compared. */
    private static final double VISIBLE = 2e-5;

    private static void isDrawnAsTraced(double day, double hours) {
        Sky sky = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, day, hours, 0, 0.2666);
        Level level = new TestLevel().sky(sky).level();
        SkyRadiance oracle = SkyRadiance.of(Daylight.at(level.environment(), 0), id -> null, ColourDecoding.SRGB)
                .orElseThrow();
        try (Offscreen offscreen = new Offscreen(3, 3);
                Renderer renderer =
                        LevelRenderer.load(offscreen.gl, level, new TestAssets(), RenderSettings.of(Output.HDR))) {
            for (Vec3 direction : DIRECTIONS) {
                renderer.draw(offscreen.view(Vec3.ZERO, direction), offscreen.picture);
                float[] drawn = renderer.readRadiance();
                Vector3d d = direction.toVector().normalize();
                Vector3d expected = oracle.from(d.x, d.y, d.z);
                assertTrue(expected.x > 0, "nothing is black");
                for (int c = 0; c < 3; c++) {
                    double most = 0.05 * expected.get(c) + 0.005 * expected.get(expected.maxComponent());
                    assertEquals(expected.get(c), drawn[12 + c], most, "day " + day + " towards " + direction);
                }
            }
            Environment now = Daylight.at(level.environment(), 0);
            NightSky night =
                    NightSky.of((Sky.Atmosphere) now.sky(), now.sun(), 0).orElseThrow();
            int stars = isTheTwins(offscreen, renderer, STARS, (direction, pixel) -> {
                Vec3 light = night.stars(direction, pixel);
                return light.y() > VISIBLE
                        ? light.plus(Vec3.of(oracle.from(direction.x(), direction.y(), direction.z())))
                        : null;
            });
            assertTrue(stars > 30, "pixels with a star: " + stars);
            if (night.towardsMoon().y() > 0) {
                Vec3 behind = Vec3.of(oracle.from(
                        night.towardsMoon().x(),
                        night.towardsMoon().y(),
                        night.towardsMoon().z()));
                View towardsMoon = narrow(night.towardsMoon(), Math.toRadians(1));
                int moon = isTheTwins(
                        offscreen,
                        renderer,
                        towardsMoon,
                        (direction, pixel) ->
                                direction.minus(night.towardsMoon()).length() < 0.9 * NightSky.MOON_RADIUS_RADIANS
                                        ? night.moon(direction).plus(behind)
                                        : null);
                assertTrue(moon > 0.15 * SIDE * SIDE, "pixels with the moon: " + moon);
            }
            offscreen.gl.requireNoError("test frames");
        }
    }

    private static View narrow(Vec3 towards, double fieldOfView) {
        return View.lookAt(Vec3.ZERO, towards, new Vec3(0, 0, 1), new Projection(fieldOfView, 1, 0.05, 1000));
    }

    /**
     * Compares the pixels of a view for which the twin has a value, and returns how many they are.
     *
     * @param twin from direction and size of a pixel, radians; {@code null} where nothing is compared
     */
    private static int isTheTwins(
            Offscreen offscreen, Renderer renderer, View view, BiFunction<Vec3, Double, Vec3> twin) {
        try (RenderTarget picture = RenderTarget.picture(offscreen.gl, "sky", PixelFormat.RGBA8, SIDE, SIDE)) {
            renderer.draw(view, picture);
        }
        float[] drawn = renderer.readRadiance();
        int compared = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            // As the shader's derivative, between the pixels of a pair.
            double pixel = ray(view, x | 1, y).minus(ray(view, x & ~1, y)).length();
            Vec3 expected = twin.apply(ray(view, x, y), pixel);
            if (expected != null) {
                double most = 0.03 * expected.y() + 1e-7;
                assertEquals(expected.x(), drawn[3 * i], most, "red of pixel " + x + ", " + y);
                assertEquals(expected.y(), drawn[3 * i + 1], most, "green of pixel " + x + ", " + y);
                assertEquals(expected.z(), drawn[3 * i + 2], most, "blue of pixel " + x + ", " + y);
                compared++;
            }
        }
        return compared;
    }

    private static Vec3 ray(View view, int x, int y) {
        double half = view.projection().tanHalfHeight();
        Vec3 right = view.right().scaled(half * ((2 * x + 1.0) / SIDE - 1));
        return Directions.unit(
                right.addScaled(half * ((2 * y + 1.0) / SIDE - 1), view.up()).minus(view.back()));
    }

    @Test
    void moonlitAirAndGroundLookAsTraced() {
        isDrawnAsTraced(FULL_MOON_DAY, 23.5);
    }

    @Test
    void aNightWithoutAMoonLooksAsTraced() {
        isDrawnAsTraced(FULL_MOON_DAY + 15, 23.5);
    }
}
