package nephele.editor.window.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.asset.LevelAssets;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The chooser of a component offers every type of file that the component reads, and no other. */
class AssetFamilyTest {
    @ParameterizedTest
    @CsvSource({
        "file, models/a.3d, a.3d b.obj c.gltf d.glb",
        "file, clouds/a.vol, e.vol",
        "heightMap, terrain/a.png, f.png g.jpg h.jpeg i.tga j.bmp k.r16",
        "heightMap, terrain/a.r16, f.png g.jpg h.jpeg i.tga j.bmp k.r16",
        "layerMap, '', f.png g.jpg h.jpeg i.tga j.bmp",
        "normalTexture, '', f.png g.jpg h.jpeg i.tga j.bmp",
        "sprite, '', f.png g.jpg h.jpeg i.tga j.bmp"
    })
    void everyTypeThatIsReadIsOffered(String component, String current, String offered, @TempDir Path folder)
            throws Exception {
        for (String name : "a.3d b.obj c.gltf d.glb e.vol f.png g.jpg h.jpeg i.tga j.bmp k.r16 l.txt".split(" ")) {
            Files.write(folder.resolve(name), new byte[0]);
        }
        List<String> found = AssetFamily.of(component, current).ids(LevelAssets.beside(folder.resolve("level.json")));
        assertEquals(
                List.of(offered.split(" ")),
                found.stream().filter(id -> !id.contains("/")).toList());
    }
}
