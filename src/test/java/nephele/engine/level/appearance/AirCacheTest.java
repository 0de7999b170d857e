package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AirCacheTest {
    @TempDir
    Path folder;

    @Test
    void whatIsKeptIsFoundByItsName() {
        byte[] field = {3, 1, 2};
        new AirCache(folder.resolve("cache")).store("air-a.field", field);
        AirCache later = new AirCache(folder.resolve("cache"));
        assertArrayEquals(field, later.find("air-a.field").orElseThrow());
        assertEquals(Optional.empty(), later.find("air-b.field"));
    }

    @Test
    void aFolderThatCannotBeWrittenOnlyKeepsNothing() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "not a folder");
        AirCache cache = new AirCache(file);
        cache.store("air-a.field", new byte[] {1});
        assertTrue(cache.find("air-a.field").isEmpty());
        assertEquals("not a folder", Files.readString(file));
    }
}
