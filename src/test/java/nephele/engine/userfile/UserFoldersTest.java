package nephele.engine.userfile;

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
                "Linux, /h, -, -, /h/.config/nephele, /h/.local/state/nephele",
                "Linux, /h, /c, /s, /c/nephele, /s/nephele",
                "Linux, /h, relative, '', /h/.config/nephele, /h/.local/state/nephele",
                "Linux, -, /c, -, /c/nephele, -",
                "Linux, -, -, -, -, -",
                "Mac OS X, /h, /c, /s, /h/Library/Application Support/nephele, /h/Library/Application Support/nephele"
            })
    void foldersFollowTheSystem(String system, String home, String config, String state, Path settings, Path progress) {
        Map<String, String> environment = new HashMap<>();
        put(environment, "HOME", home);
        put(environment, "XDG_CONFIG_HOME", config);
        put(environment, "XDG_STATE_HOME", state);
        assertEquals(new UserFolders(settings, progress), UserFolders.of(system, environment));
    }

    private static void put(Map<String, String> environment, String name, String value) {
        if (value != null) {
            environment.put(name, value);
        }
    }
}
