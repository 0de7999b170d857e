package nephele.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MesaCacheTest {
    @TempDir
    Path folder;

    @Test
    void theCacheIsSoughtWhereMesaKeepsIt() {
        assertEquals(
                List.of(Path.of("/a/.cache"), Path.of("/root/.cache")),
                MesaCache.places(Map.of("HOME", "/a"), "/root"));
        assertEquals(List.of(Path.of("/c")), MesaCache.places(Map.of("HOME", "/a", "XDG_CACHE_HOME", "/c"), "/root"));
        assertEquals(List.of(Path.of("/m")), MesaCache.places(Map.of("MESA_SHADER_CACHE_DIR", "/m"), "/root"));
    }

    @Test
    void theRoomOfAMissingFolderIsThatOfTheOneAbove() {
        assertTrue(MesaCache.hasRoom(folder.resolve("not/there"), 1));
        assertFalse(MesaCache.hasRoom(folder.resolve("not/there"), Long.MAX_VALUE));
    }
}
