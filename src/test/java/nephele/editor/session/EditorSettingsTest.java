package nephele.editor.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import nephele.engine.level.Language;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The editor's settings survive a restart, and a broken entry costs nothing but itself. */
@Execution(ExecutionMode.CONCURRENT)
class EditorSettingsTest {
    @TempDir
    Path folder;

    private final List<String> problems = new ArrayList<>();

    private EditorFiles files() {
        return EditorFiles.in(new UserFolders(folder.resolve("c"), folder.resolve("s"), folder.resolve("d")));
    }

    @Test
    void aSettingOfAnEarlierVersionGoesWithoutAWord() throws IOException {
        Path file = files().settings();
        files().save(EditorSettings.DEFAULT.with(EditorSetting.SCALE_PERCENT, 150));
        Files.writeString(
                file, Files.readString(file).replace("\"scalePercent\"", "\"viewport\": \"awt\", \"scalePercent\""));
        EditorSettings read = files().read(problems::add);
        assertEquals(List.of(), problems);
        assertEquals(150, read.get(EditorSetting.SCALE_PERCENT));
        files().save(read);
        assertFalse(Files.readString(file).contains("viewport"));
    }

    @Test
    void everySettingSurvivesARestart() throws IOException {
        EditorSettings chosen = EditorSettings.DEFAULT
                .with(EditorSetting.THEME, EditorSetting.Theme.LIGHT)
                .with(EditorSetting.SCALE_PERCENT, 150)
                .with(EditorSetting.LANGUAGE, Language.PT_BR)
                .with(EditorSetting.PANE_ARRANGEMENT, "four")
                .with(EditorSetting.SPLITTERS, Map.of("outliner", 0.25))
                .with(EditorSetting.PANELS, Map.of("problems", false))
                .with(EditorSetting.KEYS, Map.of("edit.undo", List.of("ctrl Z"), "view.front", List.of()))
                .with(EditorSetting.GUIDE_LINES, false)
                .with(EditorSetting.GUIDE_FINISHED, true)
                .withRecent(folder.resolve("a.json"));
        files().save(chosen);
        EditorSettings read = files().read(problems::add);
        assertEquals(List.of(), problems);
        for (EditorSetting<?> setting : EditorSetting.ALL) {
            assertEquals(chosen.get(setting), read.get(setting), setting.key());
            assertTrue(!read.get(setting).equals(setting.absent()), setting.key() + " was not changed by the test");
        }
        assertEquals(folder.resolve("c").resolve("editor.json"), files().settings());
        assertTrue(files().journals().startsWith(folder.resolve("s")));
    }

    static Stream<EditorSetting<?>> settings() {
        return EditorSetting.ALL.stream();
    }

    @ParameterizedTest
    @MethodSource("settings")
    void aBrokenEntryIsTheDefaultAndStays(EditorSetting<?> setting) {
        for (String broken : List.of("null", "-1e9", "1e999", "0.5", "[[]]", "{\"a\": {}}", "[3]", "{\"a\": [3]}")) {
            problems.clear();
            JsonObject entries = new JsonObject();
            entries.add(setting.key(), JsonParser.parseString(broken));
            entries.addProperty("ofALaterVersion", 3);
            EditorSettings settings = EditorSettings.of(entries, problems::add);
            assertEquals(setting.absent(), settings.get(setting), setting.key() + ": " + broken);
            assertEquals(2, problems.size(), problems::toString);
            assertTrue(problems.get(0).startsWith(setting.key() + ": must be "), problems::toString);
            EditorSettings changed = settings.withRecent(Path.of("x"));
            assertEquals(3, changed.entries().get("ofALaterVersion").getAsInt());
            if (setting != EditorSetting.RECENT_FILES) {
                assertEquals(entries.get(setting.key()), changed.entries().get(setting.key()));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "{", "[]", "null", "{\"format\": \"nephele-settings\", \"version\": 1}", "\0\0\0", "{}{}"})
    void aBrokenFileGivesTheDefaultsAndIsKept(String text) throws IOException {
        Path file = files().settings();
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        assertEquals(EditorSetting.Theme.DARK, files().read(problems::add).get(EditorSetting.THEME));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).startsWith(file.toString()), problems::toString);
        files().save(EditorSettings.DEFAULT);
        assertEquals(text, Files.readString(file.resolveSibling("editor.json.broken")));
    }

    @Test
    void theLastTwentyFilesAreRecent() {
        EditorSettings settings = EditorSettings.DEFAULT;
        for (int i = 0; i < 30; i++) {
            settings = settings.withRecent(folder.resolve(i + ".json"));
        }
        settings = settings.withRecent(folder.resolve("15.json"));
        List<String> recent = settings.get(EditorSetting.RECENT_FILES);
        assertEquals(20, recent.size());
        assertEquals(folder.resolve("15.json").toString(), recent.get(0));
        assertEquals(1, recent.stream().filter(recent.get(0)::equals).count());
        assertEquals(folder.resolve("29.json").toString(), recent.get(1));
    }

    @Test
    void aValueThatASettingDoesNotHaveIsRefused() {
        assertThrows(
                IllegalArgumentException.class, () -> EditorSettings.DEFAULT.with(EditorSetting.SCALE_PERCENT, 250));
    }

    @Test
    void withoutAFolderTheDefaultsHold() throws IOException {
        EditorFiles none = EditorFiles.in(new UserFolders(null, null, null));
        none.save(EditorSettings.DEFAULT);
        assertEquals(100, none.read(problems::add).get(EditorSetting.SCALE_PERCENT));
        assertEquals(List.of(), problems);
        assertTrue(none.journals().isAbsolute());
    }
}
