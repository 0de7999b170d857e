package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.scene.View;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Drawn models equal traced ones pixel by pixel: smooth normals, normal maps, pictures, shadows, light of the sky. */
class ModelTwinGlTest {
    private static final int SIZE = 200;

    /** Each is of one colour, so that filters have no effect: a normal that leans to the right and slightly upwards. */
    private static final TestAssets ASSETS = new TestAssets()
            .picture("leaning.png", 1, 1, (x, y) -> 0xc8a0d8)
            .picture("red.png", 1, 1, (x, y) -> 0xc04020);

    private static TestLevel shapes() {
        Material leaning = new Material("m", TestLevel.grey(0.8), "red.png", 0.4, 0.3, "leaning.png", Vec3.ZERO, 1);
        return new TestLevel()
                .material(leaning)
                .material("floor", TestLevel.grey(0.5))
                .model("box_1_2.3d", "m", at(-1.6, 0.6, 0), new Rotate(new Vec3(1, 2, 0.5), 35))
                .model("sphere_0.6_24_16.3d", "m", at(0, 0.7, 0), new Scale(new Vec3(-1, 1.1, 0.8)))
                .model("torus_0.5_0.2_32_16.3d", "m", at(1.6, 0.8, 0), new Rotate(new Vec3(1, 0, 0), 60))
                .model("cone_0.5_1_24_3.3d", null, at(-0.8, 0, 1.4))
                .model(
                        "bezier_6.3d",
                        "m",
                        at(0.9, 0, 1.5),
                        new Rotate(new Vec3(1, 0, 0), -90),
                        new Scale(TestLevel.grey(0.25)));
    }

    private static Translate at(double x, double y, double z) {
        return new Translate(new Vec3(x, y, z));
    }

    /** Without shadows, where only rounding differs, at most one pixel in a hundred, at an edge, differs. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void lightWithoutShadowsIsTheSame(boolean sunny) {
        TestLevel level = sunny
                ? shapes().ambient(0.2).sun(new Vec3(0.4, 0.7, 0.5), 3)
                : shapes().ambient(0.2).light(new Light.Point("l", new Vec3(1, 2.5, 3), TestLevel.grey(9), 20, false));
        float[][] both = both(level.level());
        int differing = 0;
        int seen = 0;
        for (int i = 0; i < both[0].length; i++) {
            seen += both[1][i] > 0 ? 1 : 0;
            differing += Math.abs(both[0][i] - both[1][i]) > 0.01 * Math.max(both[1][i], 0.05) ? 1 : 0;
        }
        assertTrue(seen > 20_000, seen + " values");
        assertTrue(differing < 0.01 * seen, differing + " of " + seen + " values differ");
    }

    /** With shadows and the sky, the mean agrees, and nearly all pixels within a tenth. */
    @Test
    void shadowsAndSkyAreNearlyTheSame() {
        Level level = shapes().skyLight()
                .sky(new Sky.Gradient(new Vec3(0.4, 0.6, 1), TestLevel.grey(0.8), TestLevel.grey(0.2)))
                .castingSun(new Vec3(0.4, 0.7, 0.5), 3)
                .box("floor", new Vec3(0, -0.5, 0), new Vec3(9, 1, 9))
                .level();
        float[][] both = both(level);
        double drawn = 0;
        double traced = 0;
        int differing = 0;
        for (int i = 0; i < both[0].length; i++) {
            drawn += both[0][i];
            traced += both[1][i];
            differing += Math.abs(both[0][i] - both[1][i]) > 0.1 * both[1][i] ? 1 : 0;
        }
        assertTrue(Math.abs(drawn / traced - 1) < 0.01, drawn / traced + " of the light");
        assertTrue(differing < 0.05 * both[0].length, differing + " of " + both[0].length + " values differ");
    }

    /** Returns the drawn and the traced picture. */
    private static float[][] both(Level level) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(0.3, 2, 3.2), new Vec3(0, 0.4, 0.3));
            float[] drawn = offscreen.radiance(level, ASSETS, view);
            TracedLevel twin = TracedLevel.of(PlacedLevel.of(level, ASSETS), ColourDecoding.SRGB);
            int samples = level.environment().ambient() == null ? 48 : 1;
            TraceSettings settings = new TraceSettings(SIZE, SIZE, samples, 1, 2);
            return new float[][] {
                drawn, ReferencePicture.trace(twin, TracedPictures.pinhole(view), settings, done -> {})
            };
        }
    }
}
