package nephele.app;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of files and folders with characters that the locale lacks. */
@Execution(ExecutionMode.CONCURRENT)
class Utf8LocaleTest {
    @TempDir
    Path temporary;

    @BeforeEach
    void requireUtf8() {
        boolean isUtf8 = "UTF-8".equals(System.getProperty("sun.jnu.encoding"));
        assumeTrue(isUtf8 && System.getProperty("os.name").equals("Linux"), "a system that can name the files");
    }

    private ChildJvm run(Map<String, String> locale, String... words) throws Exception {
        return ChildJvm.run(Files.createDirectories(temporary.resolve("peça")), locale, words);
    }

    private static void assertWords(ChildJvm run) {
        assertFalse((run.out() + run.err()).matches("(?s).*(Exception|Malformed|\\tat ).*"), run.out() + run.err());
    }

    @Test
    void underAnyLocaleAccentedNamesAreReadAndWritten() throws Exception {
        Path folder = Files.createDirectories(temporary.resolve("peça"));
        Path home = folder.resolve("ninguém");
        Files.writeString(
                folder.resolve("roteiro-é.txt"),
                """
                brush shape=box min=0,0,0 max=1,1,1
                save file=日本.json
                """);
        Files.writeString(folder.resolve("aberto-ã.json"), "{\"format\": \"nephele-level\", \"version\": 1}");
        var posix = Map.of("LC_ALL", "POSIX", "HOME", home.toString());
        var run = run(posix, Main.class.getName(), "edit", "aberto-ã.json", "--script", "roteiro-é.txt");
        assertWords(run);
        assertTrue(Files.readString(folder.resolve("日本.json")).contains("solids"), run.err());
    }

    /** {@code LC_CTYPE} is what a second start has, so that there is none. */
    @ParameterizedTest
    @ValueSource(
            strings = {"check nível.json", "scene --out=é.png", "simulate levels/samples/walking.json --replay=é.json"})
    void withoutUtf8TheLocaleIsNamed(String line) throws Exception {
        var locale = Map.of("LC_ALL", "C", "LC_CTYPE", "C.UTF-8", "DISPLAY", "");
        var run = run(locale, (Main.class.getName() + " " + line).split(" "));
        assertWords(run);
        assertTrue((run.out() + run.err()).contains("the locale C has no such characters"), run.out() + run.err());
        assertTrue(run.exitCode() == 1 || run.exitCode() == 2, "exit code " + run.exitCode());
    }
}
