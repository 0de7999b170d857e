package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ResourceAssetsTest {
    private static final byte[] SAVED = {1, 2, 3};

    @TempDir
    Path checkout;

    @Test
    void theFilesOfTheCheckoutWinOverTheJars() throws IOException {
        Path levels = Files.createDirectories(checkout.resolve("levels/samples"));
        Files.write(levels.resolve("empty.json"), SAVED);
        Files.write(levels.resolve("new.json"), SAVED);
        var jar = new ResourceAssets("/levels", null);
        var both = new ResourceAssets("/levels", checkout.toString());
        assertArrayEquals(SAVED, both.bytes("samples/empty.json"));
        assertArrayEquals(SAVED, both.bytes("samples/new.json"));
        assertFalse(jar.exists("samples/new.json"));
        assertTrue(both.exists("samples/walking.json") && both.exists("samples/new.json"));
        assertArrayEquals(jar.bytes("samples/walking.json"), both.bytes("samples/walking.json"));
    }
}
