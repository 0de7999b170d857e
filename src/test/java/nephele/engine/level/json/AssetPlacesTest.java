package nephele.engine.level.json;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** A file that is unusable for a reason that no rule knows is told at its place. */
class AssetPlacesTest {
    @Test
    void eachFileHasThePathOfItsFirstPlace() {
        String text =
                """
                {"format": "nephele-level", "version": 1,
                 "environment": {"sky": {"kind": "skybox", "files": ["a.png", "b.png", "a.png", "a.png", "a.png", "a.png"]}},
                 "materials": [{"id": "m", "texture": "b.png", "normalTexture": "n.png"}],
                 "terrains": [{"id": "t", "heightMap": "h.r16", "centre": [0, 0, 0], "sizeMetres": [9, 9],
                   "heightRangeMetres": [0, 1]}],
                 "models": [{"id": "tree", "file": "tree.obj", "impostor": true,
                   "field": {"count": 3, "spacingMetres": 1, "densityMap": "d.png"}}]}
                """;
        Map<String, String> places =
                AssetPlaces.of(LevelJson.read("level.json", text.getBytes(StandardCharsets.UTF_8)));
        assertEquals("environment.sky.files[0]", places.get("a.png"));
        assertEquals("environment.sky.files[1]", places.get("b.png"));
        assertEquals("materials[0].normalTexture", places.get("n.png"));
        assertEquals("terrains[0].heightMap", places.get("h.r16"));
        assertEquals("models[0].file", places.get("tree.obj"));
        assertEquals("models[0].field.densityMap", places.get("d.png"));
        assertEquals(6, places.size(), List.copyOf(places.keySet()).toString());
    }
}
