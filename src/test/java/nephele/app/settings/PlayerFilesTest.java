package nephele.app.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import nephele.engine.level.Language;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Settings and progress survive a restart, and a broken entry costs nothing but itself. */
class PlayerFilesTest {
    @TempDir
    Path folder;

    private final List<String> problems = new ArrayList<>();

    private PlayerFiles files() {
        return new PlayerFiles(new UserFolders(folder.resolve("c"), folder.resolve("s"), folder.resolve("d")));
    }

    @Test
    void whatIsKeptIsThereAfterARestart() {
        PlayerFiles first = files();
        first.keep(first.settings().with(Settings.LANGUAGE, Language.PT_BR).with(Settings.FIELD_OF_VIEW, 105.0));
        first.keep(first.progress().withFinished("01-courtyard.json", 3467, 0, 0));
        PlayerFiles second = files();
        assertEquals(List.of(), second.takeProblems());
        assertEquals(Language.PT_BR, second.settings().get(Settings.LANGUAGE));
        assertEquals(105, second.settings().get(Settings.FIELD_OF_VIEW));
        assertEquals(Settings.QualityPreset.AUTO, second.settings().get(Settings.QUALITY));
        assertTrue(second.progress().isFinished("01-courtyard.json"));
        assertFalse(second.progress().isFinished("02-first-shot.json"));
    }

    static Stream<GameSetting<?>> settings() {
        return Settings.ALL.stream();
    }

    @ParameterizedTest
    @MethodSource("settings")
    void aBrokenEntryIsTheDefaultAndStays(GameSetting<?> setting) {
        for (String broken :
                List.of("null", "{}", "\"no such word\"", "-1e9", "1e999", "true", "[\"No Such Key\"]", "[[]]")) {
            problems.clear();
            JsonObject entries = new JsonObject();
            entries.add(setting.key(), JsonParser.parseString(broken));
            entries.addProperty("ofALaterVersion", 3);
            GameSettings read = GameSettings.of(entries, problems::add);
            assertEquals(setting.absent(), read.get(setting), broken);
            assertEquals(2, problems.size(), problems.toString());
            assertTrue(problems.get(0).startsWith(setting.key() + ": must be "), problems.get(0));
            assertEquals(entries, read.entries());
        }
    }

    /** A setting of numbers has its least and its greatest, but not the next number beyond either. */
    @ParameterizedTest
    @MethodSource("settings")
    void aNumberJustOutsideItsRangeIsBroken(GameSetting<?> setting) {
        Matcher range = Pattern.compile("number from (\\S+) to (\\S+)")
                .matcher(setting.values().expected());
        if (!range.find()) {
            return;
        }
        double least = Double.parseDouble(range.group(1));
        double most = Double.parseDouble(range.group(2));
        for (double within : List.of(least, most, Math.nextUp(least), Math.nextDown(most))) {
            assertTrue(setting.values().read(new JsonPrimitive(within)).isPresent(), setting.key() + " " + within);
        }
        for (double outside : List.of(Math.nextDown(least), Math.nextUp(most), Double.MIN_VALUE, -1e308, 1e308)) {
            assertTrue(setting.values().read(new JsonPrimitive(outside)).isEmpty(), setting.key() + " " + outside);
        }
    }

    /** A cap of 5e-324 frames a second would be a game that never draws its second frame. */
    @Test
    void aRateIsNoneOrOneThatAGameCanHave() {
        for (GameSetting<Double> rate : List.of(Settings.FRAME_CAP, Settings.AUTO_FRAME_RATE)) {
            for (String hostile : List.of("5e-324", "1e-300", "0.5", "9.99", "1e300", "-5e-324")) {
                assertTrue(rate.values().read(JsonParser.parseString(hostile)).isEmpty(), hostile);
            }
            assertEquals(0.0, rate.values().read(JsonParser.parseString("0")).orElseThrow());
            assertEquals(10, rate.values().read(JsonParser.parseString("10")).orElseThrow());
        }
    }

    @ParameterizedTest
    @MethodSource("settings")
    void aStepOfTheMenuIsAValueAndAllAreReached(GameSetting<?> setting) {
        assertSteps(setting);
    }

    private static <T> void assertSteps(GameSetting<T> setting) {
        GameSettings now = GameSettings.DEFAULT;
        for (int i = 0; i < 100; i++) {
            GameSettings next = now.stepped(setting, i < 60 ? 1 : -1);
            List<String> told = new ArrayList<>();
            assertEquals(
                    next.get(setting),
                    GameSettings.of(next.entries(), told::add).get(setting));
            assertEquals(List.of(), told);
            now = next;
        }
    }

    @Test
    void theBestRunIsKept() {
        Progress progress = Progress.NONE
                .withFinished("a.json", 500, 3, 0)
                .withFinished("a.json", 700, 1, 0)
                .withFinished("b.json", 100, 2, 0);
        assertEquals(500, progress.bestTicks("a.json"));
        assertEquals(3, progress.portals("a.json"));
        assertEquals(400, progress.withFinished("a.json", 400, 9, 0).bestTicks("a.json"));
        assertEquals(2, progress.portals("b.json"));
        assertEquals(0, progress.bestTicks("c.json"));
    }

    @Test
    void hintsOfTheBestRunAndLearnedActionsAreKept() {
        Progress progress = Progress.NONE.withFinished("a.json", 500, 3, 2).withLearned("walk");
        assertEquals(2, progress.hints("a.json"));
        assertTrue(progress.withFinished("a.json", 700, 1, 0).hasLearned("walk"));
        assertEquals(2, progress.withFinished("a.json", 700, 1, 0).hints("a.json"));
        assertEquals(0, progress.withFinished("a.json", 400, 1, 0).hints("a.json"));
        Progress broken = Progress.of(
                JsonParser.parseString(
                                "{\"learned\": 5, \"levels\": {\"a.json\": {\"finished\": true, \"bestTicks\": 9,"
                                        + " \"portals\": 1}}}")
                        .getAsJsonObject(),
                problems::add);
        assertEquals(List.of("learned: must be a list of actions; it is written anew"), problems);
        assertEquals(0, broken.hints("a.json"), "files of earlier versions count none");
        assertTrue(broken.withLearned("run").hasLearned("run"));
    }

    @Test
    void aBrokenLevelIsUnfinishedAndTheOthersStay() {
        JsonObject members = JsonParser.parseString(
                        """
                        {"levels": {
                          "good.json": {"finished": true, "bestTicks": 10, "portals": 1, "note": "kept"},
                          "text.json": "finished",
                          "half.json": {"finished": true},
                          "negative.json": {"finished": true, "bestTicks": -1, "portals": 1},
                          "fraction.json": {"finished": true, "bestTicks": 1.5, "portals": 1}}}""")
                .getAsJsonObject();
        Progress progress = Progress.of(members, problems::add);
        assertEquals(4, problems.size());
        assertTrue(progress.isFinished("good.json"));
        assertFalse(progress.isFinished("half.json"));
        Progress changed = progress.withFinished("good.json", 5, 0, 0);
        JsonObject levels = changed.members().getAsJsonObject("levels");
        assertEquals("finished", levels.get("text.json").getAsString());
        assertEquals("kept", levels.getAsJsonObject("good.json").get("note").getAsString());
        assertEquals(5, changed.bestTicks("good.json"));
    }

    @Test
    void problemsNameTheFile() throws IOException {
        Files.createDirectories(folder.resolve("c"));
        Path settings = folder.resolve("c").resolve("settings.json");
        Files.writeString(settings, "{\"format\": \"nephele-settings\", \"version\": 1, \"language\": \"xx\"}");
        assertEquals(
                List.of(settings + ": language: must be one of en, pt-br, pt-pt; it is left as it is"),
                files().takeProblems());
    }
}
