package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Body;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A picture is a pure function of level, eye, size, samples and seed. */
@Execution(ExecutionMode.CONCURRENT)
class ReferencePictureTest {
    private static final Pinhole EYE = Traced.eye(new Vec3(1, 2, 4), Vec3.ZERO, 0.7);

    private static final List<String> SKY = List.of("sky0", "sky1", "sky2", "sky3", "sky4", "sky5");

    private static TestLevel stage() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.1, 0.2, 0.9), TestLevel.grey(0.7), TestLevel.grey(0.2)))
                .material("m", TestLevel.grey(0.5))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(6, 1, 6))
                .box("m", new Vec3(0, 0.5, 0), TestLevel.grey(1));
    }

    private static float[] picture(int samples, long seed, int threads) {
        return Traced.picture(stage(), EYE, new TraceSettings(24, 18, samples, seed, threads));
    }

    @Test
    void threadsDoNotChangeIt() {
        float[] one = picture(5, 7, 1);
        assertArrayEquals(one, picture(5, 7, 2));
        assertArrayEquals(one, picture(5, 7, 3));
    }

    @Test
    void aSeedChangesTheNoiseAndNotTheMean() {
        float[] first = picture(64, 1, 2);
        float[] second = picture(64, 2, 2);
        assertFalse(Arrays.equals(first, second));
        assertEquals(mean(first), mean(second), 2e-3);
        assertEquals(mean(picture(1024, 3, 2)), mean(first), 2e-3);
    }

    /** Returns a level with every traced feature except fog and constant ambient light, which hide the sky's. */
    private static TestLevel everything() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Skybox(SkyboxLayout.FACES, SKY))
                .material(new Material("floor", TestLevel.grey(0.9), "tiles", null, null, null, Vec3.ZERO, 0.7))
                .material(new Material("bumpy", new Vec3(0.8, 0.5, 0.2), "tiles", 0.5, 0.7, "bumps", Vec3.ZERO, 0.4))
                .material(new Material("glow", TestLevel.grey(0.2), null, null, null, null, new Vec3(0.9, 0.4, 0.1), 1))
                .gloss("gloss", new Vec3(0.8, 0.5, 0.2), 0.3, 0.7)
                .box("floor", new Vec3(0, -0.5, 0), new Vec3(6, 1, 6))
                .box("bumpy", new Vec3(0, 0.5, 0), TestLevel.grey(1))
                .box("glow", new Vec3(-1, 0.1, 1), new Vec3(0.3, 0.2, 0.3))
                .castingSun(new Vec3(0.3, 0.8, 0.4), 2)
                .light(new Light.Point("lamp", new Vec3(1, 2.5, 1), TestLevel.grey(3), 8, true))
                .light(new Light.Spot(
                        "spot", new Vec3(-1, 2, 2), new Vec3(0.2, -1, -0.5), new Vec3(1, 2, 6), 9, 10, 25, true))
                .body(new Body.Sphere("ball", new Vec3(1.2, 0.3, 1), 0.3, 1, "gloss", 0.5, 0.5))
                .body(new Body.Box("cube", new Vec3(-0.3, 0.2, 1.6), TestLevel.grey(0.4), 1, "floor", 0.5, 0.5))
                .body(new Body.Capsule("pill", new Vec3(0.6, 0.4, 1.5), 0.15, 0.8, 1, "bumpy", 0.5, 0.5))
                .portal("a", "b", new Vec3(0, 1, 0.5), new Vec3(0, 0, 1), 1, 2)
                .portal("b", "a", new Vec3(-0.5, 1, 0), new Vec3(-1, 0, 0), 1, 2);
    }

    private static TestAssets pictures() {
        var assets = new TestAssets();
        for (int i = 0; i < SKY.size(); i++) {
            int face = i;
            assets.picture(SKY.get(i), 3, 3, (x, y) -> 0x204060 + 0x180c04 * (x + face) + 0x101010 * y);
        }
        return assets.picture("tiles", 5, 3, (x, y) -> 0x302010 * (x + 1) % 0xffffff ^ 0x404040 * y)
                .seeThroughPicture(
                        "bumps", 3, 4, (x, y) -> 0x50 * (y % 2 + 1) << 24 | 0x506080 + 0x300000 * x + 0x1000 * y);
    }

    /** The checksums of two pictures are unchanged; if one changes, raise the version to discard older pictures. */
    @Test
    void aPictureKeptUnderThisVersionIsStillRight() {
        assertEquals(4, ReferencePicture.VERSION);
        assertEquals(11.32671241, weighted(everything()), 1e-6);
        assertEquals(14.79067521, weighted(everything().ambient(0.3).fog(0.05, new Vec3(0.3, 0.4, 0.5))), 1e-6);
    }

    private static double weighted(TestLevel stage) {
        float[] rgb = Traced.picture(stage, pictures(), EYE, new TraceSettings(48, 36, 16, 1, 2));
        double sum = 0;
        for (int i = 0; i < rgb.length; i++) {
            sum += rgb[i] * (1 + i % 97);
        }
        return sum / rgb.length;
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum / values.length;
    }
}
