package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.level.BadLevel;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;

/** Hints that cannot be read or are never given, and pars that no run reaches, are warnings. */
class GuidanceRulesTest {
    private static final String EXIT = "\"exits\": [{\"id\": \"e\", \"feet\": [0, 0, 0]}], ";

    private static Level level(String sections) {
        return LevelJson.read("x", BadLevel.wrap(sections).getBytes(StandardCharsets.UTF_8));
    }

    private static List<String> problems(Level level) {
        return LevelRules.check(List.of(GuidanceRules.HINTS, GuidanceRules.PAR), level, null, null).stream()
                .map(Problem::path)
                .toList();
    }

    private static String par(int portals) {
        return "\"par\": {\"seconds\": 1.5, \"portals\": " + portals + "}";
    }

    @Test
    void aParNeedsAnExitAndPortalsAGun() {
        assertEquals(List.of(), problems(level(EXIT + "\"portalGun\": {}, " + par(2))));
        assertEquals(List.of("par"), problems(level(par(0))));
        assertEquals(List.of("par.portals"), problems(level(EXIT + par(2))));
        assertEquals(List.of(), problems(level(EXIT + par(0))));
    }

    @Test
    void aRecordingBelongsToALevelWhateverItsPar() {
        assertEquals(LevelJson.sha256(level(EXIT + par(0))), LevelJson.sha256(level(EXIT + par(3))));
    }

    @Test
    void aHintThatIsTooLongForASmallWindowOrForNobodyIsAWarning() {
        String text = "é".repeat(150);
        String hints = "\"hints\": [{\"id\": \"a\", \"text\": {\"en\": \"x\", \"pt-BR\": \"" + text + "\"}}]";
        assertEquals(List.of("hints[0].text.pt-br"), problems(level("\"player\": {\"feet\": [0, 0, 5]}, " + hints)));
        assertEquals(List.of("hints[0].text.pt-br", "hints"), problems(level(hints)));
    }
}
