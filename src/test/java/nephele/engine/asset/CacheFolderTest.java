package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CacheFolderTest {
    @TempDir
    private Path temporary;

    private CacheFolder cache;

    @BeforeEach
    void limitOfThreeFiles() {
        cache = new CacheFolder(temporary.resolve("cache"), "light-*.bin", 300);
    }

    private void store(String name, int bytes, long usedMillis) throws IOException {
        cache.store(name, new byte[bytes]);
        Files.setLastModifiedTime(cache.folder().resolve(name), FileTime.fromMillis(usedMillis));
    }

    private List<String> names() throws IOException {
        try (Stream<Path> all = Files.list(cache.folder())) {
            return all.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void longestUnusedGoesWhenANewOneDoesNotFit() throws IOException {
        store("light-a.bin", 100, 2000);
        store("light-b.bin", 100, 1000);
        store("light-c.bin", 100, 3000);
        cache.store("light-d.bin", new byte[50]);
        assertEquals(List.of("light-a.bin", "light-c.bin", "light-d.bin"), names());
    }

    @Test
    void findingAFileIsUsingIt() throws IOException {
        store("light-a.bin", 150, 1000);
        store("light-b.bin", 150, 2000);
        assertArrayEquals(new byte[150], cache.find("light-a.bin").orElseThrow());
        cache.store("light-c.bin", new byte[100]);
        assertEquals(List.of("light-a.bin", "light-c.bin"), names());
        assertTrue(cache.find("light-b.bin").isEmpty());
    }

    @Test
    void oneThatIsTooLargeStaysAlone() throws IOException {
        store("light-a.bin", 100, 1000);
        cache.store("light-b.bin", new byte[400]);
        assertEquals(List.of("light-b.bin"), names());
    }

    @Test
    void filesOfOthersStay() throws IOException {
        Files.createDirectories(cache.folder());
        Files.write(cache.folder().resolve("notes.txt"), new byte[1000]);
        store("light-a.bin", 300, 1000);
        cache.store("light-b.bin", new byte[300]);
        assertEquals(List.of("light-b.bin", "notes.txt"), names());
    }
}
