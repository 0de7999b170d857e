package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The drawn sky of a night against the oracle's: moonlit air, glow, and the planet's ground lit by both. */
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

    private static void isDrawnAsTraced(double day, double hours) {
        Sky sky = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, day, hours, 0, 0.2666);
        Level level = new TestLevel().sky(sky).level();
        SkyRadiance oracle = SkyRadiance.of(Daylight.at(level.environment(), 0), id -> null, ColourDecoding.SRGB)
                .orElseThrow();
        try (Offscreen offscreen = new Offscreen(3, 3);
                Renderer renderer =
                        Renderer.load(offscreen.gl, level, new TestAssets(), RenderSettings.of(Output.HDR))) {
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
            offscreen.gl.requireNoError("test frames");
        }
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
