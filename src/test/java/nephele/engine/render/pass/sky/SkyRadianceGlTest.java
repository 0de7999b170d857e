package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Sun;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.FrameState;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The sky that lights surfaces equals the drawn one. */
class SkyRadianceGlTest {
    /** Returns pictures in which every quarter of every face has its own colour. */
    private static TestAssets pictures() {
        TestAssets assets = new TestAssets();
        for (int face = 0; face < 6; face++) {
            int f = face;
            assets.picture("f" + f + ".png", 32, 32, (x, y) -> colour(f, x / 16 + 2 * (y / 16)));
        }
        return assets.picture(
                "cross.png", 128, 96, (x, y) -> colour(x / 32 + 4 * (y / 32), x / 16 % 2 + 2 * (y / 16 % 2)));
    }

    private static int colour(int cell, int quarter) {
        return (20 + 18 * cell) << 16 | (60 + 60 * quarter) << 8 | 30 * (cell % 8);
    }

    @Test
    void everySkyLightsAsItLooks() {
        List<Sky> skies = List.of(
                new Sky.Skybox(SkyboxLayout.FACES, List.of("f0.png", "f1.png", "f2.png", "f3.png", "f4.png", "f5.png")),
                new Sky.Skybox(SkyboxLayout.CROSS, List.of("cross.png")),
                new Sky.Skybox(SkyboxLayout.CROSS, List.of("cross.png"), 0.25),
                new Sky.Gradient(new Vec3(0.1, 0.2, 0.9), new Vec3(0.7, 0.7, 0.6), new Vec3(0.3, 0.2, 0.1)),
                new Sky.Constant(new Vec3(0.1, 0.2, 0.3)),
                new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, 172, 4.6, 0, 0.2666));
        TestAssets assets = pictures();
        for (Sky sky : skies) {
            SkyRadiance radiance = SkyRadiance.of(
                            Daylight.at(new TestLevel().sky(sky).level().environment(), 0),
                            id -> PictureDecoder.decode(id, assets.bytes(id)),
                            ColourDecoding.SRGB)
                    .orElseThrow();
            try (Offscreen offscreen = new Offscreen(3, 3);
                    Renderer renderer = LevelRenderer.load(
                            offscreen.gl, new TestLevel().sky(sky).level(), assets, RenderSettings.of(Output.HDR))) {
                SplittableRandom random = new SplittableRandom(5);
                for (int i = 0; i < 24; i++) {
                    Vector3d d = quarterMiddle(random, i % 6);
                    renderer.draw(offscreen.view(Vec3.ZERO, new Vec3(d.x, d.y, d.z)), offscreen.picture);
                    float[] drawn = renderer.readRadiance();
                    Vector3d expected = radiance.from(d.x, d.y, d.z);
                    for (int c = 0; c < 3; c++) {
                        assertEquals(expected.get(c), drawn[12 + c], 4e-3, sky.getClass() + " towards " + d);
                    }
                }
                if (sky instanceof Sky.Atmosphere) {
                    theBrightestSunIsFinite(offscreen, renderer);
                }
                offscreen.gl.requireNoError("test frames");
            }
        }
    }

    /** Disc and aureole are cut at the greatest half float, even those of a sun whose light overflows a float. */
    private static void theBrightestSunIsFinite(Offscreen offscreen, Renderer renderer) {
        Environment dawn = renderer.scene().level().environment();
        Vec3 towards = dawn.sun().directionTowardsSun();
        FrameState state = FrameState.atStart(renderer.scene().level());
        for (double irradiance : new double[] {1e9, 1e39}) {
            state.environment(dawn.with(new Sun(towards, new Vec3(irradiance, irradiance, irradiance), true)));
            renderer.draw(offscreen.view(Vec3.ZERO, towards), state, offscreen.picture);
            for (float value : renderer.readRadiance()) {
                assertEquals(65504, value);
            }
        }
    }

    /** Returns a direction through the middle of a quarter of a face, where no filter mixes colours. */
    private static Vector3d quarterMiddle(SplittableRandom random, int face) {
        double s = random.nextBoolean() ? 0.5 : -0.5;
        double t = random.nextBoolean() ? 0.45 : -0.45;
        double w = (face & 1) == 0 ? 1 : -1;
        Vector3d d =
                face / 2 == 0 ? new Vector3d(w, s, t) : face / 2 == 1 ? new Vector3d(s, w, t) : new Vector3d(s, t, w);
        return d.normalize();
    }
}
