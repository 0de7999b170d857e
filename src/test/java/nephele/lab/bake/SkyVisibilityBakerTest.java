package nephele.lab.bake;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class SkyVisibilityBakerTest {
    /**
     * Every level ships with its baked light: a bake at the first start takes longer than the two seconds that are
     * allowed.
     */
    @Test
    void levelsOfTheGameCarryTheirLight() throws IOException {
        for (String folder : List.of("levels", "levels/samples")) {
            for (Path level : SkyVisibilityBaker.levels(Path.of(folder))) {
                var name = SkyVisibilityBaker.fileNameFor(level);
                assertTrue(
                        name.isEmpty() || Files.exists(Path.of(folder, "baked", name.get())),
                        level
                                + " has changed since its light was baked; run: ./nephele bake LEVEL --light, and"
                                + " commit levels/");
            }
        }
    }
}
