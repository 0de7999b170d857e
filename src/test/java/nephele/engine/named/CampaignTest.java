package nephele.engine.named;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.level.json.LevelFormatException;
import org.junit.jupiter.api.Test;

class CampaignTest {
    private static Campaign read(String levels) {
        String text = "{\"format\": \"nephele-campaign\", \"version\": 1, \"levels\": [" + levels + "]}";
        return Campaign.read("campaign.json", text.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void aLevelStandsOnceInACampaign() {
        assertEquals(List.of("a.json", "b.json"), read("\"a.json\", \"b.json\"").levels());
        LevelFormatException refusal =
                assertThrows(LevelFormatException.class, () -> read("\"a.json\", \"b.json\", \"a.json\", \"a.json\""));
        assertEquals(
                List.of(
                        "c: levels[2]: 'a.json' is already levels[0]: a level is played once, delete one",
                        "c: levels[3]: 'a.json' is already levels[0]: a level is played once, delete one"),
                refusal.problems().stream().map(problem -> problem.line("c")).toList());
    }
}
