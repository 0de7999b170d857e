package nephele.host.userfile;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Files of the user are read whatever is in them, and nothing is lost when they are saved again. */
@Execution(ExecutionMode.CONCURRENT)
class UserFileTest {
    private static final String GOOD = "{\n"
            + "  \"format\": \"nephele-settings\",\n"
            + "  \"version\": 1,\n"
            + "  \"language\": \"pt-br\",\n"
            + "  \"later\": [1, {\"x\": 1e400}]\n"
            + "}\n";

    @TempDir
    Path folder;

    private final List<String> problems = new ArrayList<>();

    private UserFile file() {
        return new UserFile(folder.resolve("settings.json"), "nephele-settings", 1);
    }

    private static JsonObject entry(String key, String value) {
        JsonObject members = new JsonObject();
        members.addProperty(key, value);
        return members;
    }

    /** Sixty broken contents. */
    static Stream<byte[]> broken() {
        List<byte[]> all = new ArrayList<>();
        byte[] good = GOOD.getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < 24; i++) {
            all.add(Arrays.copyOf(good, i * (good.length - 3) / 24));
        }
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 12; i++) {
            byte[] noise = new byte[1 + i * 40];
            random.nextBytes(noise);
            all.add(noise);
        }
        Stream.of(
                        "[]",
                        "3",
                        "null",
                        "\"text\"",
                        "{}",
                        "{\"format\": \"nephele-settings\"}",
                        "{\"format\": \"nephele-settings\", \"version\": 2}",
                        "{\"format\": \"nephele-settings\", \"version\": \"1\"}",
                        "{\"format\": \"nephele-progress\", \"version\": 1}",
                        "{\"format\": 7, \"version\": 1}",
                        "{'format': 'nephele-settings', 'version': 1}",
                        "{format: nephele-settings}",
                        GOOD + "{",
                        GOOD + GOOD,
                        GOOD.replace("\"pt-br\"", "NaN"),
                        GOOD.replace("\"pt-br\"", "0x10"),
                        GOOD.replace(",\n  \"later", "\n  \"later"),
                        GOOD.replace("}\n", ",}\n"),
                        "// comment\n" + GOOD,
                        "[".repeat(100_000),
                        "{\"a\":".repeat(50_000),
                        " ".repeat(1 << 20) + GOOD,
                        "\u0000".repeat(64))
                .forEach(text -> all.add(text.getBytes(StandardCharsets.UTF_8)));
        all.add(GOOD.getBytes(StandardCharsets.UTF_16));
        assertEquals(60, all.size());
        return all.stream();
    }

    @Test
    void aSecondBrokenFileDoesNotReplaceTheFirst() throws IOException {
        Path settings = folder.resolve("settings.json");
        for (String text : List.of("one", "two", "two")) {
            Files.writeString(settings, text);
            file().save(entry("language", "en"));
        }
        assertEquals("one", Files.readString(folder.resolve("settings.json.broken")));
        assertEquals("two", Files.readString(folder.resolve("settings.json.broken-2")));
        assertTrue(Files.notExists(folder.resolve("settings.json.broken-3")));
    }

    @ParameterizedTest
    @MethodSource("broken")
    void aBrokenFileGivesItsBackupAndIsKept(byte[] bytes) throws IOException {
        Path settings = folder.resolve("settings.json");
        file().save(entry("language", "pt-pt"));
        file().save(entry("language", "en"));
        Files.write(settings, bytes);
        JsonObject read = file().read(problems::add);
        assertEquals(entry("language", "pt-pt"), read);
        assertEquals(1, problems.size());
        assertTrue(problems.get(0).startsWith(settings + ": "), problems.get(0));
        file().save(entry("language", "pt-br"));
        assertArrayEquals(bytes, Files.readAllBytes(folder.resolve("settings.json.broken")));
        assertEquals(entry("language", "pt-br"), file().read(problems::add));
        assertEquals(1, problems.size());
        Files.write(settings, bytes);
        Files.delete(folder.resolve("settings.json.bak"));
        assertEquals(new JsonObject(), file().read(problems::add));
        assertEquals(2, problems.size());
    }

    @Test
    void unknownMembersAreKeptAsTheyAre() throws IOException {
        Files.writeString(folder.resolve("settings.json"), GOOD);
        JsonObject read = file().read(problems::add);
        file().save(read);
        assertEquals(List.of(), problems);
        assertEquals(
                JsonParser.parseString(GOOD),
                JsonParser.parseString(Files.readString(folder.resolve("settings.json"))));
        assertTrue(Files.readString(folder.resolve("settings.json")).contains("1e400"));
    }

    @Test
    void aMissingFileIsEmptyAndSilent() {
        assertEquals(new JsonObject(), file().read(problems::add));
        assertEquals(List.of(), problems);
    }

    @Test
    void aFolderInTheFilesPlaceIsReportedAndNotReplaced() throws IOException {
        Files.createDirectory(folder.resolve("settings.json"));
        assertEquals(new JsonObject(), file().read(problems::add));
        assertEquals(1, problems.size());
        IOException unsaved = assertThrows(IOException.class, () -> file().save(new JsonObject()));
        assertTrue(
                unsaved.getMessage().startsWith(folder.resolve("settings.json").toString()), unsaved.getMessage());
        assertTrue(Files.isDirectory(folder.resolve("settings.json")));
    }

    @Test
    void withoutAPlaceNothingIsSaved() throws IOException {
        UserFile none = new UserFile(null, "nephele-settings", 1);
        none.save(entry("language", "en"));
        assertEquals(new JsonObject(), none.read(problems::add));
        assertFalse(Files.exists(Path.of("settings.json")));
    }
}
