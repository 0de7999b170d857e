package nephele.host.userfile;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The user's folders are those that the system's conventions name. */
class UserFoldersTest {
    @ParameterizedTest
    @CsvSource(
            nullValues = "-",
            value = {
                "Linux, /h, -, -, -, /h/.config/nephele, /h/.local/state/nephele, /h/.local/share/nephele",
                "Linux, /h, /c, /s, /d, /c/nephele, /s/nephele, /d/nephele",
                "Linux, /h, relative, '', x, /h/.config/nephele, /h/.local/state/nephele, /h/.local/share/nephele",
                "Linux, -, /c, -, -, /c/nephele, -, -",
                "Linux, -, -, -, -, -, -, -",
                "Mac OS X, /h, /c, /s, /d, /h/Library/Application Support/nephele, /h/Library/Application"
                        + " Support/nephele,/h/Library/Application Support/nephele"
            })
    void foldersFollowTheSystem(
            String system,
            String home,
            String config,
            String state,
            String data,
            Path settings,
            Path progress,
            Path own) {
        Map<String, String> environment = new HashMap<>();
        put(environment, "HOME", home);
        put(environment, "XDG_CONFIG_HOME", config);
        put(environment, "XDG_STATE_HOME", state);
        put(environment, "XDG_DATA_HOME", data);
        UserFolders folders = UserFolders.of(system, environment);
        assertEquals(new UserFolders(settings, progress, own), folders);
        assertEquals(own == null ? null : own.resolve("levels"), folders.levels());
    }

    private static void put(Map<String, String> environment, String name, String value) {
        if (value != null) {
            environment.put(name, value);
        }
    }
}
