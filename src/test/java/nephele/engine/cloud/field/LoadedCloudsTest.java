package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Environment;
import nephele.engine.level.json.LevelJsonTest;
import org.junit.jupiter.api.Test;

/** All clouds of an environment have their media, in their order, as shells where the ground is round. */
class LoadedCloudsTest {
    private static final String CLOUDS =
            """
            "clouds": [
              {"id": "a", "kind": "layer", "baseAltitudeMetres": 1000, "thicknessMetres": 300, "albedo": 0.9},
              {"id": "b", "kind": "volume", "centre": [0, 900, 0], "size": [9, 9, 9], "phaseG": 0.85},
              {"id": "c", "kind": "layer", "baseAltitudeMetres": 1000, "thicknessMetres": 300,
               "density": {"kind": "puffs", "puffs": [{"centre": [0, 0, 0], "radiusMetres": 9}]}},
              {"id": "d", "kind": "layer", "baseAltitudeMetres": 1000, "thicknessMetres": 300,
               "windMetresPerSecond": [10, 0, 0], "density": {"kind": "noise", "coverageMap": "a.png"}}]
            """;

    private static List<CloudMedium> media(String members, double seconds) {
        Environment environment =
                LevelJsonTest.sections("\"environment\": {" + members + "}").environment();
        return LoadedClouds.of(environment, TestPictures.COVERAGE).at(seconds);
    }

    @Test
    void everyCloudHasItsOptics() {
        List<CloudMedium> media = media(CLOUDS, 0);
        assertEquals(4, media.size());
        assertEquals(0.9, media.get(0).albedo());
        assertEquals(CloudOptics.of(1, 0.85), media.get(1).phase());
        assertInstanceOf(UniformField.class, media.get(0).field());
        assertInstanceOf(NoiseField.class, media.get(3).field());
    }

    @Test
    void layersAreShellsUnderAnAtmosphereButForPlacedPuffs() {
        List<CloudMedium> media = media("\"sky\": {\"kind\": \"atmosphere\"}, " + CLOUDS, 0);
        assertInstanceOf(ShellField.class, media.get(0).field());
        assertInstanceOf(EllipsoidField.class, media.get(1).field());
        assertInstanceOf(PuffsField.class, media.get(2).field());
        assertInstanceOf(ShellField.class, media.get(3).field());
    }

    @Test
    void timeMovesThem() {
        var before = media(CLOUDS, 0).get(3).field();
        var after = media(CLOUDS, 60).get(3).field();
        for (int n = 0; n < 100; n++) {
            assertEquals(before.perMetre(31 * n, 1100, 5), after.perMetre(31 * n + 600, 1100, 5), 1e-12);
        }
    }

    @Test
    void theWeatherComesLast() {
        Environment environment = LevelJsonTest.sections("\"environment\": {\"weather\": \"broken\", " + CLOUDS + "}")
                .environment();
        var ids = LoadedClouds.of(environment, TestPictures.COVERAGE).clouds().stream()
                .map(cloud -> cloud.id())
                .toList();
        assertEquals(List.of("a", "b", "c", "d", "weather-stratocumulus", "weather-altocumulus"), ids);
    }

    @Test
    void aDamagedPictureIsRefusedWithItsName() {
        Environment environment =
                LevelJsonTest.sections("\"environment\": {" + CLOUDS + "}").environment();
        var refusal = assertThrows(
                AssetException.class, () -> LoadedClouds.of(environment, TestPictures.always(new byte[9])));
        assertEquals("a.png", refusal.getMessage().split(":")[0]);
    }
}
