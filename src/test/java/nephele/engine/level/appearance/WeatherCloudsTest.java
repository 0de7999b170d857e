package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density.Noise;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.Weather;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.LevelJsonTest;
import nephele.engine.rule.LevelRules;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** A weather is a pure function to one to three good clouds, as low, thick and many as its name says. */
class WeatherCloudsTest {
    private static final int SEEDS = 50;

    @ParameterizedTest
    @EnumSource(Weather.class)
    void aSeedAlwaysMeansTheSameClouds(Weather weather) {
        Set<List<Cloud>> different = new HashSet<>();
        for (long seed = -3; seed < SEEDS; seed++) {
            List<Cloud> clouds = WeatherClouds.of(weather, seed);
            assertEquals(clouds, WeatherClouds.of(weather, seed));
            assertTrue(clouds.size() <= 3 && clouds.isEmpty() == (weather == Weather.CLEAR), clouds.toString());
            different.add(clouds);
        }
        assertTrue(weather == Weather.CLEAR || different.size() == SEEDS + 3, "seeds give different clouds");
        assertEquals(
                WeatherClouds.of(weather, Long.MAX_VALUE).size(),
                WeatherClouds.of(weather, 0).size());
    }

    @ParameterizedTest
    @EnumSource(Weather.class)
    void theCloudsCanBeWrittenAndAreGood(Weather weather) {
        for (long seed = 0; seed < SEEDS; seed++) {
            var environment = new Environment(
                    null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, WeatherClouds.of(weather, seed));
            Level level = Level.of("", "", environment, List.of());
            assertEquals(
                    environment.clouds(),
                    LevelJsonTest.read(LevelJson.write(level)).environment().clouds());
            List<Problem> problems = LevelRules.checkRecords(level).stream()
                    .filter(problem -> problem.path().startsWith("environment"))
                    .toList();
            assertEquals(List.of(), problems);
        }
    }

    /** Eighths of the sky of the lowest layer that is no torn cloud, metres of its base and its top. */
    @ParameterizedTest
    @CsvSource({
        "FEW, cumulus, 1, 2, 1000, 2300",
        "SCATTERED, cumulus, 2.5, 4, 900, 2800",
        "BROKEN, stratocumulus, 5, 7, 900, 1800",
        "OVERCAST, stratus, 8, 8, 600, 1600",
        "STORM, cumulonimbus, 6, 8, 600, 10700",
        "CIRRUS, cirrus, 4, 8, 8000, 10200"
    })
    void coverAndAltitudeAreThoseOfTheName(
            Weather weather, String genus, double least, double most, double base, double top) {
        for (long seed = 0; seed < SEEDS; seed++) {
            Cloud cloud = WeatherClouds.of(weather, seed).stream()
                    .filter(one -> one.id().equals("weather-" + genus))
                    .findFirst()
                    .orElseThrow();
            var layer = (Cloud.Extent.Layer) cloud.extent();
            double eighths = 8 * ((Noise) cloud.density()).coverage();
            assertTrue(eighths >= least && eighths <= most, eighths + " eighths");
            assertTrue(layer.baseAltitudeMetres() >= base, layer.toString());
            assertTrue(layer.baseAltitudeMetres() + layer.thicknessMetres() <= top, layer.toString());
        }
    }

    @Test
    void cirrusIsThinnerThanOpticalDepthOne() {
        for (Weather weather : new Weather[] {Weather.CIRRUS, Weather.SCATTERED}) {
            Cloud cirrus = WeatherClouds.of(weather, 3).stream()
                    .filter(one -> one.id().equals("weather-cirrus"))
                    .findFirst()
                    .orElseThrow();
            double thickness = ((Cloud.Extent.Layer) cirrus.extent()).thicknessMetres();
            assertTrue(cirrus.extinctionPerMetre() * thickness < 1, cirrus.toString());
        }
    }

    @Test
    void writtenCloudsComeFirst() {
        Cloud written = WeatherClouds.of(Weather.CIRRUS, 9).get(0);
        var calm = new Environment(null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of(written));
        assertSame(calm.clouds(), WeatherClouds.all(calm));
        var few = new Environment(
                null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of(written), Weather.FEW, 4);
        assertEquals(written, WeatherClouds.all(few).get(0));
        assertEquals(WeatherClouds.of(Weather.FEW, 4), WeatherClouds.all(few).subList(1, 2));
        assertNotEquals(WeatherClouds.of(Weather.FEW, 5), WeatherClouds.all(few).subList(1, 2));
    }
}
