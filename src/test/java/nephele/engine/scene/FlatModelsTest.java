package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.model.MeshTexts;
import nephele.engine.rule.LevelRules;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A model without any triangle of positive area causes a warning and draws nothing. */
class FlatModelsTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"line.3d|", "zero.gltf|", "box_1_1.3d|{\"kind\": \"scale\", \"by\": [1e6, 1e-6, 1]}"})
    void areWarnedOfAndDrawNothing(String file, String step) throws IOException {
        Files.writeString(folder.resolve("line.3d"), MeshTexts.LINE);
        Files.writeString(folder.resolve("zero.gltf"), MeshTexts.ZERO_GLTF);
        AssetSource assets = LevelAssets.beside(folder.resolve("flat.json"));
        Level level = LevelJson.read("flat.json", level(file, step == null ? "" : step));
        var problems = LevelRules.checkRecordsAndFiles(level, assets);
        assertEquals(1, problems.size(), problems::toString);
        String line = problems.get(0).line("flat.json");
        assertTrue(
                line.startsWith("flat.json: models[0]: warning: 'm' draws nothing: none of the triangles of " + file),
                line);
        assertTrue(Scene.of(level, assets).solids().isEmpty());
    }

    private static byte[] level(String file, String step) {
        String text = "{\"format\": \"nephele-level\", \"version\": 1, \"player\": {\"feet\": [0, 0, 5]},"
                + " \"models\": [{\"id\": \"m\", \"file\": \"" + file + "\", \"transform\": [" + step + "]}]}";
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
