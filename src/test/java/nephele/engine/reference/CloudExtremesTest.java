package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density;
import nephele.engine.level.Cloud.Extent;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The reference at the limits of what a level may write about clouds. */
@Execution(ExecutionMode.CONCURRENT)
class CloudExtremesTest {
    private static final Sky WHITE = new Sky.Constant(TestLevel.grey(1));
    private static final Extent BOX = new Extent.Volume(new Vec3(0, 10, -60), new Vec3(60, 40, 50));
    private static final Extent LAYER = new Extent.Layer(30, 40);

    private static Cloud cloud(String id, Extent extent, Density density, double extinctionPerMetre, double phaseG) {
        return new Cloud(id, extent, CloudTechnique.AUTO, density, extinctionPerMetre, 1, phaseG);
    }

    private static TestLevel stage(Sky sky) {
        return new TestLevel()
                .skyLight()
                .sky(sky)
                .castingSun(new Vec3(1, 2, -0.5), 3)
                .material("m", TestLevel.grey(0.6))
                .box("m", new Vec3(0, -3, -20), new Vec3(30, 1, 30));
    }

    private static float[] picture(TestLevel level, Pinhole eye, int samples) {
        return Traced.picture(level, eye, new TraceSettings(8, 8, samples, 3, 1));
    }

    private static Pinhole ahead() {
        return Traced.eye(new Vec3(0, 0, 0), new Vec3(0, 1, -10), 0.7);
    }

    static Stream<Cloud> invisible() {
        return Stream.of(
                cloud("thin", BOX, new Density.Ellipsoid(), 0, 0.85),
                cloud("thin-layer", LAYER, new Density.Ellipsoid(), 0, 0.85),
                cloud("thin-noise", BOX, new Density.Noise(1, 9, 0.5), 0, 0.85),
                cloud("nowhere", BOX, new Density.Noise(1, 9, 0), 0.1, 0.85),
                cloud("nowhere-layer", LAYER, new Density.Noise(1, 9, 0), 0.1, 0.85),
                cloud("no-heaps", LAYER, new Density.Noise(1, 9, 0, 0.5, CloudProfile.CUMULUS, null, 0), 0.1, 0.85),
                cloud("no-puffs", BOX, new Density.Puffs(List.of(), null), 0.1, 0.85));
    }

    @Test
    void aCloudWithoutOpticalDepthChangesNoBit() {
        TestLevel together = stage(WHITE);
        float[] without = picture(stage(WHITE).ambient(0.1), ahead(), 2);
        invisible().forEach(cloud -> {
            assertArrayEquals(without, picture(stage(WHITE).ambient(0.1).cloud(cloud), ahead(), 2), cloud.id());
            together.cloud(cloud);
        });
        assertArrayEquals(picture(stage(WHITE), ahead(), 2), picture(together, ahead(), 2), "in the sky's light");
    }

    @Test
    void cloudsWithoutOpticalDepthChangeNoBitOfAnAtmosphere() {
        TestLevel level = stage(Sky.Atmosphere.CLEAR).ambient(0.1);
        float[] without = picture(level, ahead(), 1);
        invisible().forEach(level::cloud);
        assertArrayEquals(without, picture(level, ahead(), 1));
    }

    static Stream<Cloud> dense() {
        return Stream.of(
                cloud("ball", BOX, new Density.Ellipsoid(), 200, 0.85),
                cloud("layer", LAYER, new Density.Ellipsoid(), 250, 0),
                cloud("noise", BOX, new Density.Noise(1, 9, 0.9), 300, 0.5),
                cloud("heaps", LAYER, new Density.Noise(1, 9, 0.9, 0.5, CloudProfile.CUMULUS, null, 0), 300, 0.85));
    }

    /** At an optical depth of 10⁴ and more, light is finite, not negative, and there is some. */
    @ParameterizedTest
    @MethodSource("dense")
    void aCloudOfTenThousandOpticalDepthsIsLitAndFinite(Cloud cloud) {
        float[] radiance = Traced.picture(stage(WHITE).cloud(cloud), ahead(), new TraceSettings(3, 3, 1, 3, 1));
        double sum = 0;
        for (float value : radiance) {
            assertTrue(value >= 0 && Float.isFinite(value), cloud.id() + ": " + value);
            sum += value;
        }
        assertTrue(sum / radiance.length > 0.1, cloud.id() + " is lit: " + sum / radiance.length);
    }

    /** The peak of the sharpest phase function times the brightest sun that may be written, seen against the sun. */
    @Test
    void theBrightestSunBehindTheSharpestPeakIsFinite() {
        var towards = new Vec3(0, 1, -10);
        TestLevel level = new TestLevel()
                .skyLight()
                .sky(WHITE)
                .castingSun(towards, 1e9)
                .cloud(cloud("thin", BOX, new Density.Ellipsoid(), 1e-2, 0.999));
        float[] radiance = picture(level, Traced.eye(Vec3.ZERO, towards, 1e-3), 8);
        float brightest = 0;
        for (float value : radiance) {
            assertTrue(value >= 1 - 1e-6 && Float.isFinite(value), "" + value);
            brightest = Math.max(brightest, value);
        }
        assertTrue(brightest > 1e12, "the peak is seen: " + brightest);
    }

    /** White clouds in a white furnace are invisible, whatever they are and wherever the eye is. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.999, 0, 0.85, 0.999})
    void overlappingWhiteCloudsInAFurnaceAreInvisibleFromAnywhere(double g) {
        TestLevel level = new TestLevel()
                .skyLight()
                .sky(WHITE)
                .cloud(cloud("a", BOX, new Density.Ellipsoid(), 0.1, g))
                .cloud(cloud("b", BOX, new Density.Noise(1, 9, 0.9), 0.2, -g))
                .cloud(cloud("c", LAYER, new Density.Ellipsoid(), 0.05, g));
        TracedLevel traced = traced(level);
        double[][] eyes = {
            {0, 0, 0}, {0, 10, -60}, {20, 25, -75}, {0, 50, 0}, {0, 69.999, 0}, {0, 70, 0}, {0, 30, 0}, {1e6, 50, -1e6}
        };
        for (double[] at : eyes) {
            var eye = new Vec3(at[0], at[1], at[2]);
            Pinhole seen = Traced.eye(eye, eye.plus(new Vec3(1, 0.1, -3)), 0.7);
            for (float value : ReferencePicture.trace(traced, seen, new TraceSettings(4, 4, 2, 3, 1), done -> {})) {
                assertEquals(1, value, 1e-6, "from " + eye);
            }
        }
    }

    /** A scene far from the origin has the picture of one at the origin, but for roundings that turn single paths. */
    @ParameterizedTest
    @ValueSource(doubles = {1e6, -1e6, 1 << 24})
    void aSceneAMillionMetresAwayHasTheSamePicture(double away) {
        float[] near = moved(0);
        float[] far = moved(away);
        int differing = 0;
        double sum = 0;
        double expected = 0;
        for (int i = 0; i < near.length; i++) {
            differing += Math.abs(near[i] - far[i]) > 1e-4 * near[i] ? 1 : 0;
            sum += far[i];
            expected += near[i];
        }
        assertTrue(differing <= near.length / 10, differing + " of " + near.length + " values differ");
        assertEquals(expected, sum, 0.01 * expected);
    }

    private static float[] moved(double away) {
        var by = new Vec3(away, 0, -away);
        Extent box = new Extent.Volume(new Vec3(0, 10, -60).plus(by), new Vec3(60, 40, 50));
        Density puffs =
                new Density.Puffs(List.of(new Cloud.Puff(Vec3.ZERO, 12), new Cloud.Puff(new Vec3(-15, 3, 5), 9)), null);
        TestLevel level = new TestLevel()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.9), TestLevel.grey(0.6), new Vec3(0.2, 0.1, 0)))
                .castingSun(new Vec3(1, 2, -0.5), 3)
                .cloud(cloud("a", box, puffs, 0.1, 0.85))
                .cloud(cloud("b", box, new Density.Ellipsoid(), 0.01, 0));
        return picture(level, Traced.eye(by, by.plus(new Vec3(0, 1, -10)), 0.7), 8);
    }

    /** A thousand clouds that each have a thousandth of a cloud's extinction are that cloud. */
    @Test
    void aThousandOverlappingCloudsAreOneOfTheirSum() {
        TestLevel one = new TestLevel()
                .castingSun(new Vec3(1, 2, 1), 3)
                .cloud(cloud("a", BOX, new Density.Ellipsoid(), 0.05, 0.6));
        TestLevel many = new TestLevel().castingSun(new Vec3(1, 2, 1), 3);
        for (int i = 0; i < 1000; i++) {
            many.cloud(cloud("c" + i, BOX, new Density.Ellipsoid(), 0.05 / 1000, 0.6));
        }
        var settings = new TraceSettings(2, 2, 128, 3, 1);
        Pinhole eye = Traced.eye(Vec3.ZERO, new Vec3(0, 10, -60), 0.2);
        var a = ReferencePicture.picture(traced(one), eye, settings, done -> {});
        var b = ReferencePicture.picture(traced(many), eye, settings, done -> {});
        double sum = 0;
        double variance = 0;
        for (int i = 0; i < a.rgb().length; i += 3) {
            sum += b.rgb()[i] - a.rgb()[i];
            variance += Math.pow(a.standardError()[i], 2) + Math.pow(b.standardError()[i], 2);
        }
        assertEquals(0, sum, 4 * Math.sqrt(variance));
        assertTrue(Math.sqrt(variance) < 0.3 * 4 * a.rgb()[0], "it is known well enough");
    }

    private static TracedLevel traced(TestLevel level) {
        return TracedLevel.of(PlacedLevel.of(level.level(), TestAssets.NONE), ColourDecoding.SRGB);
    }

    /** A thousand clouds side by side are finite everywhere, and white ones in a furnace still invisible. */
    @Test
    void aThousandCloudsSideBySideKeepTheFurnace() {
        TestLevel level = new TestLevel().skyLight().sky(WHITE);
        var random = new SplittableRandom(4);
        for (int i = 0; i < 1000; i++) {
            var centre = new Vec3(
                    3000 * random.nextDouble() - 1500, 200 + 100 * random.nextDouble(), -3000 * random.nextDouble());
            var extent = new Extent.Volume(centre, new Vec3(90, 50, 80));
            level.cloud(cloud("c" + i, extent, new Density.Ellipsoid(), 0.05, 0.85));
        }
        for (float value : picture(level, ahead(), 4)) {
            assertEquals(1, value, 1e-6);
        }
    }

    /** A layer that becomes thinner at the same optical depth dims light as before: 1 mm is the least that may be written. */
    @ParameterizedTest
    @ValueSource(doubles = {1000, 1, 1e-3})
    void aLayerOfNoThicknessDimsByItsOpticalDepth(double thickness) {
        Cloud cloud = new Cloud(
                "a",
                new Extent.Layer(100, thickness),
                CloudTechnique.AUTO,
                new Density.Ellipsoid(),
                1 / thickness,
                0,
                0);
        TestLevel level = new TestLevel().skyLight().sky(WHITE).cloud(cloud);
        double mu = 0.6;
        float[] seen = Traced.towards(level, Vec3.ZERO, new Vec3(0.8, mu, 0), 40_000);
        double expected = Math.exp(-1 / mu);
        assertEquals(expected, seen[0], 4 * Math.sqrt(expected * (1 - expected) / 40_000));
    }

    /** Clouds of the least size that may be written, 0.1 mm, are no trouble. */
    @Test
    void aCloudOfATenthOfAMillimetreIsFinite() {
        for (Density density :
                new Density[] {new Density.Ellipsoid(), new Density.Noise(1, 1e-3, 0.9), new Density.Noise(1, 1e3, 1)
                }) {
            Cloud speck =
                    cloud("a", new Extent.Volume(new Vec3(0, 0, -1), new Vec3(1e-4, 1e-4, 1e-4)), density, 1000, 0);
            Pinhole eye = Traced.eye(Vec3.ZERO, new Vec3(0, 0, -1), 1e-4);
            for (float value : picture(stage(WHITE).cloud(speck), eye, 8)) {
                assertTrue(Float.isFinite(value) && value >= 0, "" + value);
            }
        }
    }
}
