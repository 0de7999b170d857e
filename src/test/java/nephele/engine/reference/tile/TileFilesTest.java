package nephele.engine.reference.tile;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Part files hold what was put into them, whatever happens to them; parts that are of no use are named. */
@Execution(ExecutionMode.CONCURRENT)
class TileFilesTest {
    private static final PixelTiles TILES = new PixelTiles(40, 37);
    private static final Map<String, String> FACTS = Map.of("level", "cafe", "samples", "64", "seed", "1");

    @TempDir
    Path folder;

    private static TilePixels pixels(int tile) {
        var random = new SplittableRandom(tile);
        float[] rgb = new float[3 * TILES.pixels(tile)];
        float[] variance = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) random.nextDouble();
            variance[i] = (float) random.nextDouble();
        }
        return new TilePixels(tile, rgb, variance);
    }

    private static TiledPicture whole() {
        var picture = new TiledPicture(TILES);
        for (int tile = 0; tile < TILES.count(); tile++) {
            picture.put(pixels(tile));
        }
        return picture;
    }

    private static PartHeader header(Shard shard, Map<String, String> facts) {
        return new PartHeader(TILES, shard, facts);
    }

    /** Writes the tiles of a shard in a shuffled order, as threads finish them. */
    private Path part(String name, Shard shard, Map<String, String> facts) throws IOException {
        Path file = folder.resolve(name);
        try (PartFile part = PartFile.open(file, header(shard, facts), new TiledPicture(TILES))) {
            List<Integer> tiles = new ArrayList<>(shard.tiles(TILES).boxed().toList());
            Collections.shuffle(tiles, new Random(3));
            for (int tile : tiles) {
                part.append(pixels(tile));
            }
        }
        return file;
    }

    private List<Path> parts(int of) throws IOException {
        List<Path> files = new ArrayList<>();
        for (int number = 1; number <= of; number++) {
            files.add(part("f." + number + "-of-" + of + ".part", new Shard(number, of), FACTS));
        }
        return files;
    }

    private static String refused(List<Path> files) {
        return assertThrows(PartFileException.class, () -> MergedParts.of(files))
                .getMessage();
    }

    private static void requireTold(String message, Object... words) {
        for (Object word : words) {
            assertTrue(message.contains(word.toString()), message);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 9, 12})
    void partsMakeThePictureInAnyOrderEvenIfSomeAreEmpty(int of) throws IOException {
        List<Path> files = parts(of);
        TiledPicture expected = whole();
        for (int turn = 0; turn < 3; turn++) {
            Collections.rotate(files, 1);
            TiledPicture merged = MergedParts.of(files);
            assertArrayEquals(expected.rgb(), merged.rgb());
            assertArrayEquals(expected.standardError(), merged.standardError());
        }
    }

    @Test
    void theSharesOfAPictureAreItsTilesOnce() {
        for (int of = 1; of < 15; of++) {
            int[] seen = new int[TILES.count()];
            for (int number = 1; number <= of; number++) {
                int first = number - 1;
                int every = of;
                new Shard(number, of).tiles(TILES).forEach(tile -> {
                    seen[tile]++;
                    assertEquals(first, tile % every, "tile i is of shard i + 1 modulo n");
                });
            }
            for (int count : seen) {
                assertEquals(1, count);
            }
        }
    }

    @Test
    void theTilesOfAPictureAreItsPixelsOnce() {
        int[] seen = new int[40 * 37];
        for (int tile = 0; tile < TILES.count(); tile++) {
            for (int y = TILES.bottom(tile); y < TILES.bottom(tile) + TILES.height(tile); y++) {
                for (int x = TILES.left(tile); x < TILES.left(tile) + TILES.width(tile); x++) {
                    seen[y * 40 + x]++;
                }
            }
        }
        for (int count : seen) {
            assertEquals(1, count);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.001, 0.3, 0.5, 0.77, 0.9999})
    void aPartThatEndsAnywhereGoesOnToTheSamePicture(double at) throws IOException {
        Path file = part("f.part", Shard.WHOLE, FACTS);
        long head = header(Shard.WHOLE, FACTS).text().getBytes(StandardCharsets.UTF_8).length;
        byte[] bytes = Files.readAllBytes(file);
        int left = (int) (head + at * (bytes.length - head));
        Files.write(file, Arrays.copyOf(bytes, left));
        var picture = new TiledPicture(TILES);
        int traced = 0;
        try (PartFile part = PartFile.open(file, header(Shard.WHOLE, FACTS), picture)) {
            assertTrue(part.replaced().isEmpty());
            for (int tile = 0; tile < TILES.count(); tile++) {
                if (!picture.has(tile)) {
                    part.append(pixels(tile));
                    picture.put(pixels(tile));
                    traced++;
                }
            }
            assertEquals(TILES.count(), traced + part.found());
        }
        assertEquals(at == 0 ? 9 : (int) Math.ceil(9 * (1 - at)), traced, 1);
        assertArrayEquals(whole().rgb(), picture.rgb());
        TiledPicture merged = MergedParts.of(List.of(file));
        assertArrayEquals(whole().rgb(), merged.rgb());
        assertArrayEquals(whole().standardError(), merged.standardError());
    }

    @Test
    void aCutPartIsNamedAndWhatToDo() throws IOException {
        List<Path> files = parts(2);
        byte[] bytes = Files.readAllBytes(files.get(1));
        Files.write(files.get(1), Arrays.copyOf(bytes, bytes.length - 100));
        requireTold(
                refused(files), files.get(1), "is cut off or damaged from byte", "after 3 tiles", "run the command");
    }

    @Test
    void aDamagedPartIsNamedAndOnlyWhatIsBehindTheDamageIsTracedAgain() throws IOException {
        List<Path> files = parts(2);
        byte[] bytes = Files.readAllBytes(files.get(0));
        bytes[bytes.length / 2] ^= 4;
        Files.write(files.get(0), bytes);
        requireTold(refused(files), files.get(0), "damaged");
        var picture = new TiledPicture(TILES);
        try (PartFile part = PartFile.open(files.get(0), header(new Shard(1, 2), FACTS), picture)) {
            assertEquals(2, part.found());
        }
        requireTold(refused(files), files.get(0), "lacks 3 of its 5 tiles");
    }

    @Test
    void aMissingPartIsNamed() throws IOException {
        List<Path> files = parts(4);
        files.remove(2);
        requireTold(refused(files), "is one of 4 shards; missing: 3/4");
        files.add(folder.resolve("absent.part"));
        requireTold(refused(files), "absent.part: there is no such file; name the parts that --shard wrote");
    }

    @Test
    void aPartIsNotMergedTwiceNorWithAnotherDivision() throws IOException {
        List<Path> files = parts(2);
        Path again = part("again", new Shard(2, 2), FACTS);
        requireTold(refused(List.of(files.get(0), files.get(1), again)), again, "are both shard 2/2; name one");
        Path third = part("third", new Shard(2, 3), FACTS);
        requireTold(refused(List.of(files.get(0), third)), third, "is shard 2/3", "shard 1/2", "of one division");
    }

    @ParameterizedTest
    @CsvSource({"level, beef", "samples, 65", "seed, 2"})
    void partsOfAnotherPictureAreNamedWithTheDifference(String fact, String value) throws IOException {
        Map<String, String> other = new HashMap<>(FACTS);
        other.put(fact, value);
        Path first = part("a", new Shard(1, 2), FACTS);
        Path second = part("b", new Shard(2, 2), other);
        requireTold(
                refused(List.of(first, second)),
                second + ": belongs to another picture than " + first,
                fact + " " + value + ", not " + FACTS.get(fact));
    }

    @Test
    void partsOfAnotherSizeAreNamedWithTheDifference() throws IOException {
        Path first = part("a", new Shard(1, 2), FACTS);
        Path second = folder.resolve("b");
        PartFile.open(
                        second,
                        new PartHeader(new PixelTiles(41, 37), new Shard(2, 2), FACTS),
                        new TiledPicture(new PixelTiles(41, 37)))
                .close();
        requireTold(refused(List.of(first, second)), second, "size 41x37, not 40x37");
    }

    @Test
    void anotherPicturesPartIsReplacedAndItIsTold() throws IOException {
        Path file = part("f.part", Shard.WHOLE, FACTS);
        Map<String, String> other = Map.of("level", "cafe", "samples", "128", "seed", "1");
        try (PartFile part = PartFile.open(file, header(Shard.WHOLE, other), new TiledPicture(TILES))) {
            assertEquals(0, part.found());
            assertEquals("samples 64, not 128", part.replaced().orElseThrow());
        }
    }

    @Test
    void whatIsNoPartIsNeitherMergedNorReplaced() throws IOException {
        for (byte[] content : new byte[][] {
            "a diary".getBytes(StandardCharsets.UTF_8),
            "nephele-part 1\nsize 4x4\n\n".getBytes(StandardCharsets.UTF_8),
            {1}
        }) {
            Path file = Files.write(folder.resolve("diary"), content);
            requireTold(refused(List.of(file)), file, "is no part of a picture");
            var picture = new TiledPicture(TILES);
            var kept = assertThrows(
                    PartFileException.class, () -> PartFile.open(file, header(Shard.WHOLE, FACTS), picture));
            requireTold(kept.getMessage(), file, "delete or rename it");
            assertArrayEquals(content, Files.readAllBytes(file));
        }
    }

    @Test
    void twoRunsDoNotWriteToOnePart() throws IOException {
        Path file = folder.resolve("f.part");
        PartHeader header = header(Shard.WHOLE, FACTS);
        try (PartFile first = PartFile.open(file, header, new TiledPicture(TILES))) {
            var picture = new TiledPicture(TILES);
            String told = assertThrows(PartFileException.class, () -> PartFile.open(file, header, picture))
                    .getMessage();
            requireTold(told, file, "another run writes to it");
            first.append(pixels(0));
        }
        var picture = new TiledPicture(TILES);
        try (PartFile part = PartFile.open(file, header, picture)) {
            assertEquals(1, part.found());
        }
    }

    @Test
    void aPartsRecordOfAnUnknownTileIsDamage() throws IOException {
        Path file = part("f.part", Shard.WHOLE, FACTS);
        Files.write(file, new byte[] {0, 0, 1, 0, 0, 0, 3, 0, 9, 9, 9, 9}, StandardOpenOption.APPEND);
        requireTold(refused(List.of(file)), file, "damaged", "after 9 tiles");
    }

    @Test
    void theHeadOfAPartIsReadAsItWasWritten() {
        PartHeader header = header(new Shard(3, 7), Map.of("camera", "an eye = [1, 2]  with = signs", "empty", ""));
        assertEquals(header, PartHeader.parse(header.text()));
        assertThrows(IllegalArgumentException.class, () -> header(Shard.WHOLE, Map.of("size", "1")));
        assertThrows(IllegalArgumentException.class, () -> header(Shard.WHOLE, Map.of("a", "1\nsize 9x9")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0/3", "4/3", "1", "1/", "/2", "-1/2", "1/0", "01/2", "1/1000001", "a/b", " 1/2"})
    void whatIsNoShareIsRefused(String text) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> Shard.parse(text));
        requireTold(refusal.getMessage(), "'" + text + "' is no share: write i/n with i from 1 to n");
        assertEquals(new Shard(2, 8), Shard.parse("2/8"));
    }

    @Test
    void aPictureWithoutVarianceHasNoErrorOnceMerged() throws IOException {
        Path file = folder.resolve("f.part");
        try (PartFile part = PartFile.open(file, header(Shard.WHOLE, FACTS), new TiledPicture(TILES))) {
            for (int tile = 0; tile < TILES.count(); tile++) {
                part.append(new TilePixels(tile, pixels(tile).rgb(), new float[0]));
            }
        }
        assertFalse(MergedParts.of(List.of(file)).hasError());
    }
}
