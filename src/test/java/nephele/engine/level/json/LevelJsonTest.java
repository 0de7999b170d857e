package nephele.engine.level.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

public class LevelJsonTest {
    /** A level of one cloud, with keys that may be left out. */
    public static final String PUFF =
            """
            {
              "format": "nephele-level", "version": 1, "name": "Puff", "description": "one grid cloud",
              "environment": {
                "sun": { "directionTowardsSun": [0.3, 0.8, -0.5], "irradiance": [3, 3, 3] },
                "sky": { "kind": "constant", "radiance": [0.2, 0.3, 0.5] },
                "clouds": [ { "id": "c1", "kind": "volume", "technique": "auto",
                              "centre": [0, 0, 0], "size": [200, 200, 200],
                              "density": { "kind": "grid", "file": "puff.vol" },
                              "extinctionPerMetre": 0.05, "albedo": 0.95, "phaseG": 0.0 } ]
              },
              "cameras": [ { "id": "main", "position": [0, -20, -420], "target": [0, 0, 0], "up": [0, 1, 0], "horizontalFovDegrees": 40 } ],
              "solids": [], "lights": [], "entities": []
            }
            """;

    public static Level read(String json) {
        return LevelJson.read("test.json", json.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns a level with these sections. */
    public static Level sections(String members) {
        return read("{\"format\": \"nephele-level\", \"version\": 1, " + members + "}");
    }

    public static List<Problem> problems(String json) {
        return assertThrows(LevelFormatException.class, () -> read(json)).problems();
    }

    @Test
    void theSampleOfTheDesignLoads() {
        Level level = read(PUFF);
        assertEquals("Puff", level.name());
        assertEquals(new Vec3(0, -20, -420), level.cameras().get(0).position());
        Cloud cloud = level.environment().clouds().get(0);
        assertEquals(new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(200, 200, 200)), cloud.extent());
        assertEquals(new Cloud.Density.Grid("puff.vol"), cloud.density());
        assertEquals(0.95, cloud.albedo());
    }

    @Test
    void onlyFormatAndVersionAreNeeded() {
        Level empty = read("{\"format\": \"nephele-level\", \"version\": 1}");
        assertEquals("", empty.name());
        assertEquals(List.of(), empty.solids());
        assertEquals(ToneCurve.CLIP, empty.environment().toneCurve());
        assertEquals(null, empty.environment().sun());
        assertEquals("{\n  \"format\": \"nephele-level\",\n  \"version\": 1\n}\n", LevelJson.write(empty));
    }

    @Test
    void facesOfABoxOverrideItsDefaults() {
        Level level =
                sections("\"solids\": [{\"id\": \"s\", \"kind\": \"box\", \"centre\": [0, 1, 2], \"size\": [1, 1, 1],"
                        + " \"material\": \"m\", \"faces\": {\"+y\": {\"material\": \"w\", \"portalable\": true}}}]");
        Solid.Box box = assertInstanceOf(Solid.Box.class, level.solids().get(0));
        assertEquals(new Solid.Face("w", true, null), box.faces().get(BoxFace.PLUS_Y));
        assertEquals(TextureMapping.WORLD, box.textureMapping());
    }

    @Test
    void allProblemsAreToldAtOnceWithTheirPaths() {
        List<Problem> problems = problems("{\"format\": \"nephele-level\", \"version\": 1, \"colour\": 1,"
                + "\"solids\": [{\"id\": \"a\", \"kind\": \"box\", \"centre\": [0, \"x\", 0], \"size\": [0, 1, 1]},"
                + "{\"id\": \"b\", \"kind\": \"bxo\"}]}");
        assertEquals(
                List.of("solids[0].centre[1]", "solids[0].size[0]", "solids[1].kind", "colour"),
                problems.stream().map(Problem::path).toList());
        assertEquals(
                "test.json: solids[0].size[0]: must be from 0.0001 to 10000000, not 0",
                problems.get(1).line("test.json"));
    }
}
