package nephele.engine.level.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;

/** What a file can make the program compute is bounded, or told before. */
class FileCostTest {
    private static final String BOX =
            "{\"id\": \"s%d\", \"kind\": \"box\", \"centre\": [0, 0, 0], \"size\": [9, 9, 9]}";

    private static List<Problem> problems(LevelRule rule, String members) {
        String text = "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {}, " + members + "}";
        return LevelRules.check(
                List.of(rule),
                LevelJson.read("level.json", text.getBytes(StandardCharsets.UTF_8)),
                LevelAssets.beside(Path.of("level.json")));
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
        String planes = many(30, "{\"normal\": [0, 1, %d], \"distanceMetres\": 1}");
        String dear = "{\"id\": \"s%d\", \"kind\": \"planes\", \"planes\": " + planes + "}";
        assertEquals(List.of(), problems(SolidRules.COST, "\"solids\": " + many(2_000, BOX)));
        assertEquals(List.of(), problems(SolidRules.COST, "\"solids\": " + many(1_000, dear)));
        assertTold("21000 solids of 126000 faces need some 10 s", "\"solids\": " + many(21_000, BOX));
        assertTold("4000 solids of 120000 faces need some 11 s", "\"solids\": " + many(4_000, dear));
    }

    private static void assertTold(String words, String members) {
        List<Problem> told = problems(SolidRules.COST, members);
        assertEquals(1, told.size());
        assertEquals("solids", told.get(0).path());
        assertTrue(told.get(0).message().startsWith(words), told.get(0).message());
    }
}
