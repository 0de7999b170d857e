package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AirCacheTest {
    /** Thin air needs few orders of scattering. */
    private static final Air THIN = new Air(new Vec3(0, 0, 0), 0.5, 0.7, 1, 0);

    @TempDir
    Path folder;

    private AirTables tables(List<Double> progress) {
        return AirTables.of(THIN, new AirCache(folder.resolve("cache")), progress::add);
    }

    private static Vec3 colour(AirTables tables) {
        return new ClearSky(tables).radiance(0, new Vec3(0.6, 0.8, 0), new Vec3(0, 0.28, 0.96));
    }

    private Path stored() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("cache"))) {
            return files.findFirst().orElseThrow();
        }
    }

    @Test
    void airIsComputedOnceAndAgainIfItsFileIsDamaged() throws IOException {
        List<Double> progress = Collections.synchronizedList(new ArrayList<>());
        Vec3 computed = colour(tables(progress));
        assertEquals(1, progress.get(progress.size() - 1));
        assertTrue(progress.stream().sorted().toList().equals(progress), "it grows");
        progress.clear();
        assertEquals(computed, colour(tables(progress)), "to the last digit");
        assertTrue(progress.isEmpty(), "found");

        byte[] whole = Files.readAllBytes(stored());
        byte[] damaged = whole.clone();
        damaged[whole.length / 2] ^= 1;
        Files.write(stored(), damaged);
        AirCache cache = new AirCache(folder.resolve("cache"));
        assertThrows(
                CancellationException.class,
                () -> AirTables.of(THIN, cache, done -> {
                    throw new CancellationException("once is enough for the test");
                }));
    }
}
