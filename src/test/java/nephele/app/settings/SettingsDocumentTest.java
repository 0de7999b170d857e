package nephele.app.settings;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;

/** docs/settings.md has a row for each setting with its values and default. */
class SettingsDocumentTest {
    @Test
    void everySettingHasItsRow() throws IOException {
        String page = Files.readString(Path.of("docs/settings.md"));
        Settings.ALL.forEach(setting -> assertTrue(page.contains(row(setting)), "expected: " + row(setting)));
    }

    /** The page names the group of each setting of the menu. */
    @Test
    void everyGroupHasItsSettings() throws IOException {
        String page = Files.readString(Path.of("docs/settings.md")).replace('\n', ' ');
        for (GameSetting.Group group : GameSetting.Group.values()) {
            List<String> keys = Settings.of(group).stream()
                    .map(setting -> "`" + setting.key() + "`")
                    .toList();
            String listed = Pattern.quote("*" + Phrase.ofGroup(group).in(Language.EN) + "*") + "[^*;]*";
            String rest = Pattern.compile(listed)
                    .matcher(page)
                    .results()
                    .findFirst()
                    .orElseThrow()
                    .group();
            keys.forEach(key -> assertTrue(rest.contains(key), group + " lacks " + key));
        }
    }

    private static <T> String row(GameSetting<T> setting) {
        return "| `" + setting.key() + "` | " + setting.values().expected() + " | `"
                + setting.values().write(setting.absent()) + "` | ";
    }
}
