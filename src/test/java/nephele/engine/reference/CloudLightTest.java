package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.tile.TiledPicture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Clouds dim the light of surfaces by closed forms, and light the level as they must. */
@Execution(ExecutionMode.CONCURRENT)
class CloudLightTest {
    private static final Sky WHITE = new Sky.Constant(TestLevel.grey(1));
    private static final double ALBEDO = 0.6;

    private static TestLevel floor() {
        return new TestLevel()
                .material("m", TestLevel.grey(ALBEDO))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40));
    }

    private static Pinhole down() {
        return Traced.eye(new Vec3(0, 5, 0.01), Vec3.ZERO, 1e-3);
    }

    /** The red mean of a small picture, with its standard error. */
    private record Seen(double mean, double error) {
        static Seen of(TestLevel level, Pinhole eye, int samples) {
            TracedLevel traced = TracedLevel.of(PlacedLevel.of(level.level(), TestAssets.NONE), ColourDecoding.SRGB);
            TiledPicture picture =
                    ReferencePicture.picture(traced, eye, new TraceSettings(4, 4, samples, 5, 1), done -> {});
            double sum = 0;
            double variance = 0;
            for (int pixel = 0; pixel < 16; pixel++) {
                sum += picture.rgb()[3 * pixel] / 16;
                double error = picture.standardError()[3 * pixel] / 16;
                variance += error * error;
            }
            return new Seen(sum, Math.sqrt(variance));
        }

        void requireNear(double expected, double mostError) {
            String both = mean + " ± " + error + ", not " + expected;
            assertTrue(Math.abs(mean - expected) <= 4 * error + 1e-6, both);
            assertTrue(error <= mostError * expected, both);
        }
    }

    @Test
    void theSunReachesAFloorThroughALayerByBeerAndLambert() {
        double mu = 0.8;
        Vec3 sun = new Vec3(0.6, mu, 0);
        TestLevel level = floor().castingSun(sun, 3).layer(100, 50, 0.02, 0, 0);
        Seen.of(level, down(), 2048).requireNear(ALBEDO / Math.PI * 3 * mu * Math.exp(-1 / mu), 0.01);
        TestLevel shadowless = floor().sun(sun, 3).layer(100, 50, 0.02, 0, 0);
        Seen.of(shadowless, down(), 32).requireNear(ALBEDO / Math.PI * 3 * mu, 1e-6);
    }

    /** An absorbing layer of optical depth 1 lets 2 E₃(1) = 0.2193839344 of a uniform sky's irradiance pass. */
    @Test
    void theSkyReachesAFloorThroughALayer() {
        TestLevel level = floor().skyLight().sky(WHITE).layer(100, 50, 0.02, 0, 0);
        Seen.of(level, down(), 4096).requireNear(ALBEDO * 0.2193839344, 0.015);
    }

    /** Visibility and irradiance are independent: an absorbing layer above a wall multiplies both. */
    @Test
    void theSkysLightIsTheVisiblePartTimesWhatTheCloudsLetPass() {
        TestLevel level = floor().skyLight()
                .sky(WHITE)
                .layer(100, 50, 0.02, 0, 0)
                .box("m", new Vec3(-20.25, 1000, 0), new Vec3(40, 2000, 4000));
        Pinhole eye = Traced.eye(new Vec3(0, 5, 0), new Vec3(-0.2499, 0, 0), 1e-6);
        Seen.of(level, eye, 4096).requireNear(ALBEDO * 0.2193839344 / 2, 0.02);
    }

    @Test
    void aLampIsDimmedByTheFogAroundIt() {
        Light lamp = new Light.Point("l", new Vec3(0, 3, 0), TestLevel.grey(30), 20, true);
        double clear = Seen.of(floor().light(lamp), down(), 32).mean();
        TestLevel level = floor().light(lamp).layer(1, 1, 0.7, 0, 0);
        // The eye's ray crosses the layer once too.
        Seen.of(level, down(), 2048).requireNear(clear * Math.exp(-1.4), 0.05);
    }

    /** All light that does not come from outside comes from clouds: a white layer in a white furnace changes nothing. */
    @Test
    void aWhiteFurnaceIsWhiteFromInsideAndOutside() {
        TestLevel level = new TestLevel()
                .skyLight()
                .sky(WHITE)
                .cloud(new Vec3(0, 0, -10), new Vec3(12, 8, 12), 1, 1, 0.85)
                .cloud(new Vec3(1, 0, -10), new Vec3(1, 1, 1), 1e4, 1, -0.3)
                .material("m", TestLevel.grey(1))
                .box("m", new Vec3(0, 1000, 0), new Vec3(1, 1, 1));
        for (Vec3 eye : new Vec3[] {new Vec3(0, 0, 10), new Vec3(0, 0, -6), new Vec3(3, 1, -10)}) {
            Pinhole pinhole = Traced.eye(eye, new Vec3(0, 0.1, -10), 0.7);
            for (float value : Traced.picture(level, pinhole, new TraceSettings(5, 5, 2, 1, 1))) {
                assertEquals(1, value, 1e-6);
            }
        }
    }

    @Test
    void aFloorUnderAWhiteLayerAndAWhiteSkyIsWhite() {
        TestLevel level = floor().skyLight().sky(WHITE).layer(100, 50, 0.1, 1, 0.85);
        Seen.of(level, down(), 64).requireNear(ALBEDO, 1e-6);
    }

    @Test
    void aCloudThatIsNotThereChangesNoBit() {
        TraceSettings settings = new TraceSettings(24, 18, 5, 3, 1);
        Pinhole eye = Traced.eye(new Vec3(1, 2, 9), Vec3.ZERO, 0.7);
        TestLevel clear = floor().skyLight().sky(WHITE).castingSun(new Vec3(1, 2, 3), 2);
        TestLevel empty = floor().skyLight()
                .sky(WHITE)
                .castingSun(new Vec3(1, 2, 3), 2)
                .layer(0, 100, 0, 1, 0)
                .cloud(Vec3.ZERO, new Vec3(9, 9, 9), 0, 0.5, 0.5);
        assertArrayEquals(Traced.picture(clear, eye, settings), Traced.picture(empty, eye, settings));
    }

    /** Clouds of a size at the limit of the format, and at a million metres, give finite light. */
    @Test
    void extremeCloudsAreFinite() {
        for (double size : new double[] {1e-4, 1e7}) {
            for (double extinction : new double[] {1e-9, 1e3}) {
                TestLevel level = floor().skyLight()
                        .sky(WHITE)
                        .castingSun(new Vec3(0, 1, 0), 2)
                        .cloud(new Vec3(0, 0, -1), new Vec3(size, size, size), extinction, 0.5, 0.999);
                Pinhole eye = Traced.eye(new Vec3(0, 1, 3), Vec3.ZERO, 0.5);
                for (float value : Traced.picture(level, eye, new TraceSettings(5, 5, 4, 1, 1))) {
                    assertTrue(value >= 0 && value < 1e6, size + " m, " + extinction + ": " + value);
                }
            }
        }
    }

    /** 2²⁰ m away everything is the same but for the rounding of places. */
    @Test
    void aMillionMetresAwayTheCloudIsTheSame() {
        double mean = 0;
        double moved = 0;
        for (double far : new double[] {0, 1 << 20}) {
            Vec3 by = new Vec3(far, 0, -far);
            TestLevel level = new TestLevel()
                    .skyLight()
                    .sky(WHITE)
                    .castingSun(new Vec3(1, 1, 1), 2)
                    .cloud(new Vec3(0, 4, -10).plus(by), new Vec3(12, 8, 12), 1, 0.9, 0.5);
            Pinhole eye = Traced.eye(new Vec3(0, 2, 3).plus(by), new Vec3(0, 4, -10).plus(by), 0.7);
            float[] rgb = Traced.picture(level, eye, new TraceSettings(16, 16, 16, 1, 1));
            double sum = 0;
            for (float value : rgb) {
                sum += value / rgb.length;
            }
            mean = far == 0 ? sum : mean;
            moved = sum;
        }
        assertEquals(mean, moved, 1e-3 * mean);
    }
}
