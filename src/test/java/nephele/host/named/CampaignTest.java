package nephele.host.named;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.engine.level.Language;
import nephele.engine.level.json.LevelFormatException;
import org.junit.jupiter.api.Test;

class CampaignTest {
    private static Campaign read(String levels) {
        return read(levels, "");
    }

    /** @param more members of the file */
    private static Campaign read(String levels, String more) {
        String text = "{\"format\": \"nephele-campaign\", \"version\": 1, \"levels\": [" + levels + "]" + more + "}";
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

    /** A file without titles is as valid as before they were; its levels are called after their files. */
    @Test
    void aTitleBelongsToALevelOfTheList() {
        assertEquals(Map.of(), read("\"a.json\"").titles());
        assertEquals(
                Map.of("a.json", Map.of(Language.EN, "Hall", Language.PT_BR, "Salão")),
                read("\"a.json\"", ", \"titles\": {\"a.json\": {\"en\": \"Hall\", \"pt-BR\": \"Salão\"}}")
                        .titles());
        LevelFormatException refusal = assertThrows(
                LevelFormatException.class, () -> read("\"a.json\"", ", \"titles\": {\"b.json\": {\"en\": \"Hall\"}}"));
        assertEquals(
                List.of("c: titles.b.json: there is no such entry in levels: add it there, or delete this title"),
                refusal.problems().stream().map(problem -> problem.line("c")).toList());
        LevelFormatException unknown = assertThrows(
                LevelFormatException.class,
                () -> read("\"a.json\"", ", \"titles\": {\"a.json\": {\"fr\": \"Salle\"}}"));
        assertEquals(
                List.of("c: titles.a.json.fr: unknown key; known here: [en, pt-br, pt-pt]"),
                unknown.problems().stream().map(problem -> problem.line("c")).toList());
    }

    @Test
    void theGamesLevelsHaveTitlesInEachLanguage() {
        LevelTitles titles = LevelCatalogue.titles();
        for (Language language : Language.values()) {
            Set<String> all = LevelCatalogue.campaign().stream()
                    .map(level -> titles.of(level, language))
                    .collect(Collectors.toSet());
            assertEquals(LevelCatalogue.campaign().size(), all.size(), language + ": " + all);
        }
        LevelName first = LevelCatalogue.first();
        assertEquals("Courtyard", titles.of(first, Language.EN));
        assertEquals("Pátio", titles.of(first, Language.PT_PT));
        assertEquals("Terreno", titles.of(new LevelName("levels/samples/terrain.json"), Language.PT_BR), "a sample");
        assertEquals("Farol", titles.of("scenes/lighthouse.xml", Language.PT_PT, "Lighthouse"), "a scene");
        LevelName other = new LevelName("/somewhere/01-courtyard.json");
        assertEquals(other.title(), titles.of(other, Language.PT_PT), "another level of the same name");
        assertEquals("First shot", LevelTitles.OF_FILES.of(new LevelName("levels/02-first-shot.json"), Language.PT_BR));
    }

    @Test
    void aTitleThatALanguageLacksIsTheEnglishOneElseTheFile() {
        LevelTitles titles = new LevelTitles(
                Map.of("a.json", Map.of(Language.EN, "Hall"), "b.json", Map.of(Language.PT_BR, "Salão")),
                () -> new SampleCatalogue(List.of()));
        assertEquals("Hall", titles.of(new LevelName("levels/a.json"), Language.PT_PT));
        assertEquals("B", titles.of(new LevelName("levels/b.json"), Language.PT_PT));
        assertEquals("Salão", titles.of(new LevelName("levels/b.json"), Language.PT_BR));
    }
}
