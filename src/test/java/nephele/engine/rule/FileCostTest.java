package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Hash64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a file can make the program compute is bounded, or told before. */
class FileCostTest {
    private static final String BOX =
            "{\"id\": \"s%d\", \"kind\": \"box\", \"centre\": [0, 0, 0], \"size\": [9, 9, 9]}";

    @TempDir
    Path folder;

    private List<Problem> problems(LevelRule rule, String members) {
        String text = "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {}, " + members + "}";
        return LevelRules.check(
                List.of(rule),
                LevelJson.read("level.json", text.getBytes(StandardCharsets.UTF_8)),
                LevelAssets.beside(folder.resolve("level.json")),
                null);
    }

    private static String many(int count, String of) {
        return IntStream.range(0, count).mapToObj(of::formatted).collect(Collectors.joining(", ", "[", "]"));
    }

    private static String field(String id, int count) {
        return "{\"id\": \"" + id + "\", \"sprite\": \"s.png\", \"sizeMetres\": [1, 1], \"field\": {\"count\": " + count
                + ", \"spacingMetres\": 1}}";
    }

    /** Fields of five million places took minutes to plant before they were refused. */
    @Test
    void fieldsOfMoreThanALevelShowsAreNotPlanted() {
        String floor = "\"solids\": " + many(1, BOX) + ", \"billboards\": ";
        assertEquals(
                1,
                problems(BillboardRules.ROOM, floor + "[" + field("a", 200) + "]")
                        .size());
        assertEquals(
                List.of(),
                problems(BillboardRules.ROOM, floor + "[" + field("a", 100_001) + ", " + field("b", 100_000) + "]"));
    }

    @Test
    void solidsThatTakeLongAreWarnedOfWithAnEstimate() {
        String prism = "{\"id\": \"s%d\", \"kind\": \"prism\", \"centre\": [0, 0, 0], \"sides\": 62,"
                + " \"radiusMetres\": 1, \"heightMetres\": 1}";
        assertEquals(List.of(), problems(SolidRules.COST, "\"solids\": " + many(1_000, prism)));
        assertTold("2000 solids of 128000 faces need some 10 s", "\"solids\": " + many(2_000, prism));
        String planes = many(64, "{\"normal\": [0, 1, %d], \"distanceMetres\": 1}");
        String dear = "{\"id\": \"s%d\", \"kind\": \"planes\", \"planes\": " + planes + "}";
        assertTold("1300 solids of 83200 faces need some 11 s", "\"solids\": " + many(1_300, dear));
    }

    /** Such levels were good, and their pictures then ended with no file's name. */
    @Test
    void picturesThatNeedMuchMemoryAreWarnedOfAtTheLargest() throws IOException {
        picture("large.png", 8_000);
        picture("small.png", 100);
        List<Problem> told = problems(
                AssetRules.READABLE,
                "\"materials\": [{\"id\": \"a\", \"texture\": \"small.png\"},"
                        + " {\"id\": \"b\", \"texture\": \"small.png\", \"normalTexture\": \"large.png\"}]");
        assertEquals(1, told.size());
        assertEquals("materials[1].normalTexture", told.get(0).path());
        assertTrue(told.get(0).message().contains("some 512 MB"), told.get(0).message());
    }

    private void picture(String name, int side) throws IOException {
        var picture = new BufferedImage(side, side, BufferedImage.TYPE_BYTE_BINARY);
        // Without noise so many pixels in so few bytes are taken for damage.
        byte[] bits = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        for (int i = 0; i < Math.min(100_000, bits.length); i++) {
            bits[i] = (byte) Hash64.combine(i, 1);
        }
        ImageIO.write(picture, "png", folder.resolve(name).toFile());
    }

    @Test
    void aPictureThatMemoryDoesNotSufficeForIsNamed() {
        AssetException told = assertThrows(
                AssetException.class,
                () -> PictureDecoder.inMemory("large.png", () -> {
                    throw new OutOfMemoryError();
                }));
        assertTrue(told.getMessage().startsWith("large.png: does not fit into memory"), told.getMessage());
    }

    private void assertTold(String words, String members) {
        List<Problem> told = problems(SolidRules.COST, members);
        assertEquals(1, told.size());
        assertEquals("solids", told.get(0).path());
        assertTrue(told.get(0).message().startsWith(words), told.get(0).message());
    }
}
