package nephele.engine.reference.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.DistantLight;
import nephele.engine.reference.volume.OutsideLight;
import nephele.engine.reference.volume.VolumeTracer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The light around clouds over the planet is that of surfaces and of the sky, by day and by moonlight. */
@Execution(ExecutionMode.CONCURRENT)
class OverPlanetTest {
    /** Days of the year with a full and a half moon. */
    private static final double FULL = 20;

    private static final double HALF = 13;

    private static Environment at(double dayOfYear, double hours) {
        var sky = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, dayOfYear, hours, 0, 0.2666);
        var environment = new Environment(null, sky, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        return Daylight.at(environment, 0);
    }

    @ParameterizedTest
    @CsvSource({"172, 12", "172, 19.5", "20, 23.5", "20, 20", "13, 19", "20, 6"})
    void whatReachesTheGroundIsTheLightOfSurfaces(double dayOfYear, double hours) {
        Environment environment = at(dayOfYear, hours);
        Sun onGround = Daylight.onGround(environment);
        Vec3 towards = Directions.unit(onGround.directionTowardsSun());
        double expected = onGround.irradiance().y();
        double found = 0;
        for (DistantLight light : OverPlanet.of(environment, 1).lights()) {
            Vec3 irradiance = light.irradiance(Vec3.ZERO);
            if (light.towards().minus(towards).length() < 1e-9) {
                assertEquals(
                        onGround.irradiance().x(),
                        irradiance.x(),
                        0.004 * onGround.irradiance().x());
                found = irradiance.y();
            } else {
                assertEquals(0, irradiance.y(), 1e-12, "no other light reaches the ground");
            }
        }
        assertEquals(expected, found, 0.004 * expected);
    }

    /**
     * Around the planet, in steps of 0.01 degrees: the sun's direct light falls to nothing without a step, from the blue
     * end of its colours, and never shines through the planet from below.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1500, 10_000})
    void theSunSetsWithoutAStepAndStaysBehindThePlanet(double altitude) {
        var white = new Vec3(1, 1, 1);
        DistantLight light = new LightOverPlanet(AirTables.of(Air.CLEAR), white, white, new Vec3(1, 0, 0));
        double radius = Air.PLANET_RADIUS_METRES + altitude;
        double set = -Math.toDegrees(Math.acos(Air.PLANET_RADIUS_METRES / radius)) - 0.2666;
        Vec3 before = null;
        for (double degrees = 1; degrees > -6; degrees -= 0.01) {
            double angle = Math.toRadians(degrees);
            Vec3 now = light.irradiance(
                    new Vec3(radius * Math.sin(angle), radius * Math.cos(angle) - Air.PLANET_RADIUS_METRES, 0));
            String where = degrees + " degrees";
            assertTrue(now.x() >= now.y() && now.y() >= now.z() && now.z() >= 0 && now.x() <= 1, where + ": " + now);
            assertTrue(degrees > set ? degrees < set + 0.02 || now.x() > 0 : now.x() == 0, where + ": " + now);
            if (before != null) {
                assertTrue(now.x() <= before.x() && before.x() - now.x() < 0.02, where + ": " + before + now);
            }
            before = now;
        }
        assertEquals(Vec3.ZERO, before);
    }

    @Test
    void theMoonShinesByNightOnly() {
        assertEquals(1, OverPlanet.of(at(FULL, 12), 1).lights().size());
        assertEquals(2, OverPlanet.of(at(FULL, 23), 1).lights().size());
        double half = moonlight(at(HALF, 19));
        assertTrue(half > 0 && half < 0.3 * moonlight(at(FULL, 23)), "a half moon gives less than half of its light");
    }

    private static double moonlight(Environment night) {
        return OverPlanet.of(night, 1)
                .lights()
                .get(1)
                .irradiance(new Vec3(0, 30_000, 0))
                .y();
    }

    @ParameterizedTest
    @CsvSource({"172, 12", "20, 23.5", "13, 19", "20, 17.6"})
    void theSkyOfPathsIsTheSkyOfEyes(double dayOfYear, double hours) {
        Environment environment = at(dayOfYear, hours);
        SkyRadiance eyes =
                SkyRadiance.of(environment, id -> null, ColourDecoding.SRGB).orElseThrow();
        OverPlanet paths = OverPlanet.of(environment, 1);
        var random = new SplittableRandom(2);
        for (int i = 0; i < 40; i++) {
            Vec3 d = Directions.unit(
                    random.nextDouble() - 0.5, 0.6 * random.nextDouble() - 0.1, random.nextDouble() - 0.5);
            Vec3 expected = Vec3.of(eyes.from(2, d.x(), d.y(), d.z()));
            Vec3 found = paths.skylight(new Vec3(0, 2, 0), d);
            assertEquals(0, found.minus(expected).length(), 0.01 * expected.length(), "towards " + d);
        }
    }

    /** Near the ground a cloud in moonlight is one under a moon and a sky that are the same everywhere. */
    @Test
    void aCloudIsLitByTheMoonAsByADirectionalLight() {
        Environment night = at(FULL, 23.5);
        Sun moon = Daylight.onGround(night);
        OverPlanet planet = OverPlanet.of(night, 1);
        var field = new UniformField(new Aabb(-200, 20, -200, 200, 60, 200), 0.03);
        var media = new CloudMedia(List.of(new CloudMedium(field, 1, new HenyeyGreenstein(0.6))));
        var around =
                OutsideLight.of(moon.directionTowardsSun(), moon.irradiance(), (height, x, y, z) -> planet.skylight(
                                Vec3.ZERO, new Vec3(x, y, z))
                        .toVector());
        var dark = OutsideLight.of((height, x, y, z) ->
                planet.skylight(Vec3.ZERO, new Vec3(x, y, z)).toVector());
        var eye = new Ray(0, 0, 0, 0.3, Math.sqrt(1 - 0.09), 0);
        double[] there = mean(new VolumeTracer(media, planet), eye);
        double[] here = mean(new VolumeTracer(media, around), eye);
        double[] without = mean(new VolumeTracer(media, dark), eye);
        assertEquals(here[0], there[0], 4 * Math.hypot(here[1], there[1]) + 0.01 * here[0]);
        assertTrue(here[0] > 1.5 * without[0], "the moon gives much of its light: " + here[0] + ", " + without[0]);
    }

    private static double[] mean(VolumeTracer tracer, Ray ray) {
        var random = new SplittableRandom(1);
        double sum = 0;
        double squares = 0;
        int count = 4000;
        for (int i = 0; i < count; i++) {
            double value = tracer.radiance(ray, random).y();
            sum += value;
            squares += value * value;
        }
        double mean = sum / count;
        return new double[] {mean, Math.sqrt(Math.max(0, squares / count - mean * mean) / count)};
    }
}
