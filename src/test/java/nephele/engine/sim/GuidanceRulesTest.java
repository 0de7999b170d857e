package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;

/** Warnings about a landmark that a player who has begun cannot see, and about hints for nobody or too long to read. */
class GuidanceRulesTest {
    private static final String WALL = "\"solids\": [{\"id\": \"wall\", \"kind\": \"box\", \"centre\": [0, 2, 0],"
            + " \"size\": [20, 4, 1]}], \"player\": {\"feet\": [0, 0, 5]}, ";

    private static List<Problem> problems(String members) {
        String file = "{\"format\": \"nephele-level\", \"version\": 1, " + members + "}";
        return WorldRules.check(LevelJson.read("l", file.getBytes(StandardCharsets.UTF_8)), null).stream()
                .filter(problem ->
                        problem.path().startsWith("landmark") || problem.path().startsWith("hints"))
                .toList();
    }

    private static List<Problem> landmark(String position, double radius) {
        return problems(WALL + "\"landmark\": {\"position\": " + position + ", \"radiusMetres\": " + radius + "}");
    }

    @Test
    void aLandmarkInTheOpenOrHigherThanTheWallIsSeen() {
        assertEquals(List.of(), landmark("[0, 1, 2]", 0.5));
        assertEquals(List.of(), landmark("[0, 9, -6]", 1));
        assertEquals(List.of(), landmark("[0, 2, 0]", 1), "its surface stands out of the wall");
    }

    @Test
    void aHiddenLandmarkIsAWarningThatNamesWhatItIsIn() {
        Problem within = landmark("[0, 2, 0]", 0.4).get(0);
        assertFalse(within.isError());
        assertEquals("landmark.position", within.path());
        assertTrue(within.message().contains("inside solids[0] ('wall')"), within.message());
        Problem behind = landmark("[0, 2, -4]", 1).get(0);
        assertTrue(behind.message().contains("cannot be seen from the player's start"), behind.message());
    }

    @Test
    void aHintThatIsTooLongForASmallWindowOrForNobodyIsAWarning() {
        String text = "é".repeat(150);
        String hints = "\"hints\": [{\"id\": \"a\", \"text\": {\"en\": \"x\", \"pt-BR\": \"" + text + "\"}}]";
        assertEquals(
                List.of("hints[0].text.pt-br"),
                problems(WALL + hints).stream().map(Problem::path).toList());
        assertEquals(
                "hints[0].text.pt-br, hints",
                String.join(", ", problems(hints).stream().map(Problem::path).toList()));
    }
}
