package nephele.editor.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import nephele.editor.save.DocumentFile;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
final class MaterialLibraryTest {
    private static final MaterialLibrary LIBRARY = MaterialLibrary.STANDARD;

    @Test
    void everyPictureOfTheLibraryComesWithTheGame() {
        AssetSource assets = LevelAssets.beside(Path.of("untitled.json"));
        assertTrue(LIBRARY.materials().size() > 10);
        for (Material material : LIBRARY.materials()) {
            assertTrue(material.texture() == null || assets.exists(material.texture()), material.id());
            assertTrue(material.normalTexture() == null || assets.exists(material.normalTexture()), material.id());
        }
    }

    @Test
    void aLevelGetsAMaterialOnceAndKeepsItsOwn() {
        Level empty = DocumentFile.untitled().level();
        Level with = LIBRARY.including(empty, MaterialLibrary.FIRST);
        assertEquals(List.of(LIBRARY.find(empty, MaterialLibrary.FIRST).orElseThrow()), with.materials());
        assertSame(with, LIBRARY.including(with, MaterialLibrary.FIRST));
        assertSame(empty, LIBRARY.including(empty, null));
        assertSame(empty, LIBRARY.including(empty, "unheard-of"));
        var own = new Material(MaterialLibrary.FIRST, empty.environment().ambient(), null, null, null, null, null, 1);
        Level painted = empty.with(List.of(own), List.of());
        assertSame(painted, LIBRARY.including(painted, MaterialLibrary.FIRST));
        assertEquals(LIBRARY.materials().size() - 1, LIBRARY.missingIn(painted).size());
    }
}
