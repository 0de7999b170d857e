package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.reference.sky.SkyLight;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The light of the sky matches values calculated by hand. */
@Execution(ExecutionMode.CONCURRENT)
class SkyLightTest {
    private static final Sky WHITE = new Sky.Constant(TestLevel.grey(1));

    /** White bodies under a uniform white sky are invisible. */
    @Test
    void aWhiteFurnaceIsWhite() {
        TestLevel furnace = new TestLevel()
                .skyLight()
                .sky(WHITE)
                .material("lambert", TestLevel.grey(1))
                .gloss("insulator", TestLevel.grey(1), 0.3, 0)
                .gloss("metal", TestLevel.grey(1), 0.6, 1)
                .box("lambert", new Vec3(-2, 0, 0), TestLevel.grey(1))
                .box("insulator", new Vec3(0, 0, 0), TestLevel.grey(1))
                .box("metal", new Vec3(2, 0, 0), TestLevel.grey(1));
        // A single box, without the occlusion by the others.
        TestLevel alone = new TestLevel()
                .skyLight()
                .sky(WHITE)
                .gloss("metal", TestLevel.grey(1), 0.6, 1)
                .box("metal", Vec3.ZERO, TestLevel.grey(2));
        Pinhole eye = Traced.eye(new Vec3(1, 3, 6), Vec3.ZERO, 0.6);
        TraceSettings settings = new TraceSettings(24, 16, 4, 1, 1);
        for (float value : Traced.picture(alone, eye, settings)) {
            assertEquals(1, value, 1e-3);
        }
        for (Vec3 top : new Vec3[] {new Vec3(-2, 0.5, 0), new Vec3(0, 0.5, 0), new Vec3(2, 0.5, 0)}) {
            assertEquals(1, Traced.towards(furnace, new Vec3(1, 3, 6), top, 1)[0], 1e-3);
        }
    }

    /** An infinite wall up to the elevation φ hides (1 − cos φ) / 2 of the cosine-weighted sky. */
    @Test
    void aWallHidesItsShareOfTheSky() {
        TestLevel walled = new TestLevel()
                .skyLight()
                .sky(WHITE)
                .material("m", TestLevel.grey(1))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(4000, 1, 4000))
                .box("m", new Vec3(0, 2, -0.5), new Vec3(4000, 4, 1));
        for (double z : new double[] {1e-3, 1, 4, 20}) {
            double hidden = (1 - z / Math.sqrt(16 + z * z)) / 2;
            float seen = Traced.towards(walled, new Vec3(0.5, 3, 8), new Vec3(0, 0, z), 4096)[0];
            assertEquals(1 - hidden, seen, 2e-3, z + " m before the wall");
        }
    }

    /**
     * Under a radiance a + b y in all directions, a surface with a normal at cosine c to the zenith receives a + ⅔ b c.
     */
    @Test
    void aLinearSkyGivesTwoThirdsOfItsSlope() {
        Sky linear = new Sky.Gradient(TestLevel.grey(3), TestLevel.grey(2), TestLevel.grey(1));
        SkyLight light = new SkyLight(
                SkyRadiance.of(linear, id -> null, ColourDecoding.SRGB).orElseThrow());
        for (int i = 0; i < 200; i++) {
            double y = 1 - (i + 0.5) / 100;
            double flat = Math.sqrt(1 - y * y);
            Vector3d normal = new Vector3d(flat * Math.cos(i * 2.4), y, flat * Math.sin(i * 2.4));
            assertEquals(2 + 2.0 / 3 * y, light.ambient(normal).y, 1e-3, "towards " + normal);
        }
    }
}
