package nephele.app.settings;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** docs/settings.md has a row for each setting with its values and default. */
class SettingsDocumentTest {
    @Test
    void everySettingHasItsRow() throws IOException {
        String page = Files.readString(Path.of("docs/settings.md"));
        Settings.ALL.forEach(setting -> assertTrue(page.contains(row(setting)), "expected: " + row(setting)));
    }

    private static <T> String row(GameSetting<T> setting) {
        return "| `" + setting.key() + "` | " + setting.values().expected() + " | `"
                + setting.values().write(setting.absent()) + "` | ";
    }
}
