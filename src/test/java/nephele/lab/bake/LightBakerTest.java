package nephele.lab.bake;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import nephele.engine.asset.LevelAssets;
import nephele.engine.bake.LightBake;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Levels ship with what is baked for them, and an interrupted bake ends with the bytes of one that was not. */
class LightBakerTest {
    private static final String ROOM =
            """
            {"format": "nephele-level", "version": 1,
             "environment": {"sun": {"directionTowardsSun": [1, 2, 1], "irradiance": [3, 3, 3]}},
             "solids": [
               {"id": "floor", "kind": "box", "centre": [0, 0, 0], "size": [8, 1, 8]},
               {"id": "wall", "kind": "box", "centre": [-2, 2, 0], "size": [1, 3, 6]}]}
            """;

    private static final LightBake.Settings COARSE = LightBake.Settings.USUAL.withError(0.2);

    @TempDir
    private Path folder;

    private static byte[] baked(Path level, String log) throws IOException {
        var lines = new ByteArrayOutputStream();
        LightBaker.bake(level, COARSE, new PrintStream(lines));
        assertTrue(lines.toString().contains(log), lines.toString());
        assertFalse(Files.exists(LightBaker.part(level)));
        try (Stream<Path> files = Files.list(level.resolveSibling("baked"))) {
            return Files.readAllBytes(files.findFirst().orElseThrow());
        }
    }

    @Test
    void anInterruptedBakeGoesOnToTheSameBytes() throws IOException {
        Path whole = Files.writeString(folder.resolve("room.json"), ROOM);
        Path cut =
                Files.writeString(Files.createDirectory(folder.resolve("cut")).resolve("room.json"), ROOM);
        PlacedLevel placed = PlacedLevel.of(LevelFile.read(cut), LevelAssets.beside(cut));
        LightBake bake = LightBake.of(placed, COARSE);
        try (var checkpoint =
                LightCheckpoint.open(LightBaker.part(cut), LightBaker.facts(placed, COARSE), bake.blocks())) {
            assertThrows(
                    CancellationException.class,
                    () -> bake.run(checkpoint, done -> {
                        if (done > 0.5) {
                            throw new CancellationException();
                        }
                    }));
        }
        assertArrayEquals(baked(whole, "balancing"), baked(cut, "resumed at"));
    }

    /**
     * Every level ships with its baked light: a bake at the first start takes longer than the two seconds that are
     * allowed.
     */
    @Test
    void levelsOfTheGameCarryTheirLight() throws IOException {
        for (String folder : List.of("levels", "levels/samples")) {
            for (Path level : LightBaker.levels(Path.of(folder))) {
                var name = LightBaker.fileNameFor(level);
                assertTrue(
                        name.isEmpty() || Files.exists(Path.of(folder, "baked", name.get())),
                        level
                                + " has changed since its light was baked; run: ./nephele bake LEVEL --light, and"
                                + " commit levels/");
            }
        }
    }
}
