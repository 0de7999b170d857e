package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;

/** A landmark that cannot be seen from the player's start is a warning. */
class LandmarkRulesTest {
    private static final String WALL = "\"solids\": [{\"id\": \"wall\", \"kind\": \"box\", \"centre\": [0, 2, 0],"
            + " \"size\": [20, 4, 1]}], \"player\": {\"feet\": [0, 0, 5]}, ";

    private static List<Problem> problems(String members) {
        String file = "{\"format\": \"nephele-level\", \"version\": 1, " + members + "}";
        return LevelRules.check(LevelJson.read("l", file.getBytes(StandardCharsets.UTF_8)), null).stream()
                .filter(problem -> problem.path().startsWith("landmark"))
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
}
