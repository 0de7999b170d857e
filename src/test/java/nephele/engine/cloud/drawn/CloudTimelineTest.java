package nephele.engine.cloud.drawn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.field.CloudFields;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.Weather;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** What is drawn of clouds is a function of time and focus: it drifts, evolves, follows the eye, and forgets the way. */
@TestInstance(Lifecycle.PER_CLASS)
@Execution(ExecutionMode.CONCURRENT)
class CloudTimelineTest {
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final Vec3 SUN = new Vec3(0.6, 0.8, 0);
    private static final Aabb REGION = Aabb.around(Vec3.ZERO, new Vec3(20, 20, 20));
    /** For tests that hardly look at the light. */
    private static final int COARSE_LIGHT = 4;

    private static final CellMarch.OutsideOfCloud OUTSIDE = new CellMarch.OutsideOfCloud(SUN, ONE, ONE, Vec3.ZERO);

    private static final Environment CALM = with(layer("heaps", 1000, Vec3.ZERO, 0));

    private final CloudTimeline calm = timeline(CALM);
    /** Calm clouds around the origin, which most tests compare others with. */
    private final CloudInterval atOrigin = calm.at(CALM, 0, Vec3.ZERO);

    @AfterAll
    void close() {
        calm.close();
    }

    private static Cloud layer(String id, double base, Vec3 wind, double evolution) {
        var noise = new Cloud.Density.Noise(7, 300, 0.4, 0, CloudProfile.CUMULUS, null, 0);
        return new Cloud(
                id,
                new Cloud.Extent.Layer(base, 600),
                CloudTechnique.AUTO,
                noise,
                0.02,
                1,
                0.85,
                new Cloud.Motion(wind, evolution));
    }

    private static Environment with(Cloud... clouds) {
        return new Environment(
                new Sun(SUN, ONE, true), null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of(clouds));
    }

    private static CloudTimeline timeline(Environment environment) {
        return timeline(environment, LightCells.DIVISOR);
    }

    private static CloudTimeline timeline(Environment environment, int lightDivisor) {
        return new CloudTimeline(environment, new ResourceAssets("/assets"), REGION, lightDivisor);
    }

    /** An edit of anything else keeps the samples. */
    @Test
    void onlyWhatMakesOrLightsCloudsIsACause() {
        Environment written = with(layer("a", 800, Vec3.ZERO, 0));
        Environment edited = written.with(new Sky.Constant(ONE))
                .with(Exposure.ofStops(2))
                .withAmbient(ONE)
                .withFog(new Environment.Fog(0.01, ONE));
        assertEquals(CloudTimeline.causes(written), CloudTimeline.causes(edited));
        List<Environment> others = List.of(
                with(layer("a", 900, Vec3.ZERO, 0)),
                written.with(new Sun(ONE, ONE, true)),
                written.with(Sky.Atmosphere.CLEAR),
                new Environment(
                        written.sun(),
                        null,
                        null,
                        Exposure.NEUTRAL,
                        ToneCurve.CLIP,
                        null,
                        written.clouds(),
                        Weather.FEW,
                        1));
        for (Environment other : others) {
            assertNotEquals(CloudTimeline.causes(written), CloudTimeline.causes(other));
        }
    }

    /** Returns the light and the transmittance of rays upwards from a place near the focus. */
    private static double[] seen(CloudInterval clouds, Vec3 focus) {
        double[] seen = new double[60];
        for (int n = 0; n < 30; n++) {
            double angle = 0.7 * n;
            double slope = 0.15 + 0.03 * n;
            double level = Math.sqrt(1 - slope * slope);
            DrawnCloud cloud = clouds.from().clouds().get(0);
            var march = new CellMarch(cloud.cells(), OUTSIDE, focus.minus(cloud.drift()));
            march.march(cloud.drifting(focus, level * Math.cos(angle), slope, level * Math.sin(angle)), 0, 1e5, 1, 0.5);
            seen[2 * n] = march.radiance().x();
            seen[2 * n + 1] = march.transmittance();
        }
        return seen;
    }

    @Test
    void whatIsSeenDoesNotDependOnTheWayThere() {
        Vec3 end = new Vec3(1130, 0, -420);
        try (CloudTimeline direct = timeline(CALM)) {
            CloudInterval walked = null;
            for (int step = 0; step <= 4; step++) {
                walked = calm.at(CALM, 0, end.scaled(step / 4.0));
            }
            double[] expected = seen(direct.at(CALM, 0, end), end);
            double[] found = seen(walked, end);
            for (int i = 0; i < expected.length; i++) {
                assertEquals(expected[i], found[i], 2e-3, "value " + i);
            }
        }
    }

    @Test
    void farFromTheOriginThereIsTheSameKindOfSky() {
        var far = new Vec3(1e6, 0, -1e6);
        double near = mean(seen(atOrigin, Vec3.ZERO));
        assertEquals(near, mean(seen(calm.at(CALM, 0, far), far)), 0.35 * near);
    }

    private static double mean(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value / values.length;
        }
        return sum;
    }

    /** With the wind, an observer who drifts along sees what one at rest sees without wind. */
    @Test
    void windMovesTheWholePicture() {
        var wind = new Vec3(10, 0, -4);
        Environment windy = with(layer("heaps", 1000, wind, 0));
        double month = 30 * 86_400;
        try (CloudTimeline blown = timeline(windy)) {
            double[] expected = seen(atOrigin, Vec3.ZERO);
            CloudInterval later = blown.at(windy, month, wind.scaled(month));
            // Samples are at multiples of a step; the month is none, so the earlier sample is shown where it is.
            double sampled = later.from().clouds().get(0).drift().x() / wind.x();
            double[] found = seen(later, wind.scaled(sampled));
            for (int i = 0; i < expected.length; i++) {
                assertEquals(expected[i], found[i], 2e-3, "value " + i);
            }
            assertEquals(lightOf(later.from()), lightOf(later.to()), "clouds that only drift keep their light");
        }
    }

    private static List<LightCells> lightOf(CloudInterval.Sample sample) {
        return sample.clouds().get(0).cells().light();
    }

    @Test
    void aCaptureIsExactAtItsTime() {
        Environment environment = with(layer("heaps", 1000, new Vec3(10, 0, 0), 200));
        try (CloudTimeline timeline = timeline(environment, COARSE_LIGHT)) {
            CloudInterval later = timeline.at(environment, 777, Vec3.ZERO);
            CloudSource source = timeline.sources().get(0);
            var field = CloudFields.of(source.cloud(), new ResourceAssets("/assets"), 777);
            var noise = source.noise(777);
            Vec3 drift = source.drift(777);
            for (int n = 0; n < 200; n++) {
                var at = new Vec3(37.0 * n, 1000 + 3 * n, -91.0 * n);
                Vec3 own = at.minus(drift);
                assertEquals(
                        field.perMetre(at.x(), at.y(), at.z()),
                        noise.perMetre(own.x(), own.y(), own.z()),
                        1e-9,
                        "place " + n);
            }
            assertTrue(later.fraction() > 0 && later.fraction() < 1);
        }
    }

    @Test
    void aStillSkyIsSampledOnce() {
        CloudInterval first = calm.at(CALM, 0, Vec3.ZERO);
        assertSame(first.from(), calm.at(CALM, 1e6, new Vec3(3, 2, 1)).from());
        assertEquals(0, first.fraction());
    }

    /** Between two samples 4 s apart, the clouds of another weather were still seen at the time of a keyframe. */
    @Test
    void atAKeyframeOfTheWeatherNoOthersCloudsAreSeen() {
        Environment changing = new Environment(
                new Sun(SUN, ONE, true),
                null,
                null,
                Exposure.NEUTRAL,
                ToneCurve.CLIP,
                null,
                List.of(),
                null,
                7,
                List.of(
                        new Environment.WeatherKeyframe(1, Weather.FEW),
                        new Environment.WeatherKeyframe(2.3, Weather.CLEAR)));
        try (CloudTimeline timeline = timeline(changing, COARSE_LIGHT)) {
            double[] clear = seen(timeline.at(changing, 2.3, Vec3.ZERO), Vec3.ZERO);
            double[] cloudy = seen(timeline.at(changing, 1, Vec3.ZERO), Vec3.ZERO);
            double least = 1;
            for (int i = 1; i < clear.length; i += 2) {
                assertEquals(1, clear[i], "transmittance " + i);
                least = Math.min(least, cloudy[i]);
            }
            assertTrue(least < 0.5, "clouds before: " + least);
        }
    }

    @Test
    void aDeckAboveDarkensTheCloudBelow() {
        Cloud heaps = layer("heaps", 1000, Vec3.ZERO, 0);
        var deck = new Cloud(
                "deck",
                new Cloud.Extent.Layer(4000, 500),
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                0.06,
                1,
                0.85);
        try (CloudTimeline shaded = timeline(with(heaps, deck), COARSE_LIGHT)) {
            double bright = light(atOrigin);
            double dark = light(shaded.at(with(heaps, deck), 0, Vec3.ZERO));
            // The deck has τ 30 and g 0.85: it lets about a third through.
            assertTrue(dark < 0.6 * bright, dark + " of " + bright);
            assertTrue(dark > 0.05 * bright, dark + " of " + bright);
        }
    }

    /** A deck that has drifted over a cloud darkens it; where the deck began, and where it never was, the sun shines. */
    @Test
    void theShadeOfACloudDriftsWithIt() {
        double seconds = 400;
        var wind = new Vec3(100, 0, 0);
        Cloud heaps = layer("heaps", 1000, Vec3.ZERO, 0);
        // The sun is seen from the heaps through what is 2250 m farther along x at the deck's height.
        Vec3 over = new Vec3(2250, 4250, 0);
        var deck = new Cloud(
                "deck",
                new Cloud.Extent.Volume(over.addScaled(-seconds, wind), new Vec3(30_000, 500, 30_000)),
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                0.06,
                1,
                0.85,
                new Cloud.Motion(wind, 0));
        try (CloudTimeline shaded = timeline(with(heaps, deck), COARSE_LIGHT)) {
            double bright = light(shaded.at(with(heaps, deck), 0, Vec3.ZERO));
            double dark = light(shaded.at(with(heaps, deck), seconds, Vec3.ZERO));
            assertEquals(light(atOrigin), bright, 0.2 * bright);
            assertTrue(dark < 0.6 * bright, dark + " of " + bright);
        }
    }

    private static double light(CloudInterval clouds) {
        double[] seen = seen(clouds, Vec3.ZERO);
        double sum = 0;
        for (int i = 0; i < seen.length; i += 2) {
            sum += seen[i];
        }
        return sum;
    }
}
