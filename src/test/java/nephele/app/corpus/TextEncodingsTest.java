package nephele.app.corpus;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import nephele.engine.asset.TextFile;
import nephele.engine.choice.ErrorTable;
import nephele.engine.level.json.LevelJson;
import nephele.engine.model.file.ModelFiles;
import nephele.engine.model.shape.BezierPatches;
import nephele.engine.sim.replay.Replay;
import nephele.host.userfile.UserFile;
import nephele.scenes.xml.XmlSceneFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every text file of a user in the encodings that editors write: read, or refused by the encoding's name. */
class TextEncodingsTest {
    private static final Pattern OTHER_DECODING =
            Pattern.compile("Files\\.(readString|readAllLines|lines|newBufferedReader)\\(");

    /** Files of the system or of this program's own processes, which only this system writes. */
    private static final List<String> NO_USERS_FILES = List.of(
            "StartProfile.java",
            "Provenance.java",
            "JvmVariant.java",
            "JitMatrixProof.java",
            "EditorOpenSaveProof.java",
            "ComparedLevel.java");

    @TempDir
    static Path folder;

    /** Reads bytes, or throws an exception with a message for users. */
    @FunctionalInterface
    interface Reading {
        Object read(byte[] bytes) throws Exception;
    }

    /** @param text with more than one line and a letter that is not ASCII */
    private record Kind(String name, String text, Reading reading) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static Stream<Kind> kinds() {
        String level = "{\n\"format\": \"nephele-level\",\n\"version\": 1,\n\"name\": \"Pêra\"\n}\n";
        String replay = "{\n\"format\": \"nephele-replay\",\n\"version\": 1,\n\"levelName\": \"Pêra\",\n"
                + "\"level\": \"0000000000000000\",\n\"ticksPerSecond\": 120,\n\"inputs\": []\n}\n";
        return Stream.of(
                new Kind("script of the editor", "# Pêra\nbrush shape=box\n", TextEncodingsTest::lines),
                new Kind("level", level, bytes -> LevelJson.read("a.json", bytes)),
                new Kind("replay", replay, bytes -> Replay.read("r.json", bytes)),
                new Kind("settings", level.replace("-level", "-kept"), TextEncodingsTest::settings),
                new Kind(
                        "XML scene",
                        "<scene>\n<!-- Pêra -->\n<models><model file='a.3d'/></models></scene>\n",
                        bytes -> XmlSceneFile.read("a.xml", bytes)
                                .root()
                                .models()
                                .size()),
                new Kind("mesh", "3\n0 0 0\n1 0 0\n0 1 0\n", bytes -> ModelFiles.read("a.3d", bytes, name -> null)
                        .triangleCount()),
                new Kind("Wavefront mesh", "# Pêra\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", bytes -> ModelFiles.read(
                                "a.obj", bytes, name -> null)
                        .triangleCount()),
                new Kind(
                        "patches",
                        "1\n0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n1\n0,0,0\n",
                        bytes -> BezierPatches.read("a.patch", bytes).patches().size()),
                new Kind(
                        "table of errors",
                        String.join("\n", ErrorTable.shipped().lines().subList(0, 3)),
                        bytes -> ErrorTable.read(lines(bytes), "a.csv").rows().size()));
    }

    private static List<String> lines(byte[] bytes) throws IOException {
        return TextFile.lines(Files.write(folder.resolve("a.txt"), bytes));
    }

    private static Object settings(byte[] bytes) throws IOException {
        var problems = new ArrayList<String>();
        var read = new UserFile(Files.write(folder.resolve("a.json"), bytes), "nephele-kept", 1).read(problems::add);
        if (!problems.isEmpty()) {
            throw new IOException(problems.get(0));
        }
        return read;
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void aByteOrderMarkAndAnyLineEndsChangeNothing(Kind kind) {
        byte[] usual = kind.text.getBytes(StandardCharsets.UTF_8);
        for (String text : List.of("\ufeff" + kind.text, kind.text.replace("\n", "\r\n"))) {
            byte[] changed = text.getBytes(StandardCharsets.UTF_8);
            assertEquals(
                    assertDoesNotThrow(() -> kind.reading.read(usual)),
                    assertDoesNotThrow(() -> kind.reading.read(changed)));
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void anotherEncodingIsNamed(Kind kind) {
        for (String charset : List.of("UTF-16", "UTF-16LE", "UTF-16BE", "x-UTF-16LE-BOM", "UTF-32LE", "UTF-32BE")) {
            byte[] bytes = kind.text.getBytes(Charset.forName(charset));
            String message = assertThrows(Exception.class, () -> kind.reading.read(bytes), charset)
                    .getMessage();
            assertTrue(
                    message.contains("it is " + charset.replaceAll(".*(UTF-\\d\\d).*", "$1")),
                    charset + ": " + message);
            assertTrue(message.contains("save it as UTF-8"), message);
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void latin1IsReadWhereItsLettersDontMatterAndElseNamed(Kind kind) {
        byte[] bytes = kind.text.getBytes(StandardCharsets.ISO_8859_1);
        if (kind.name.contains("mesh") || kind.name.equals("patches") || kind.name.startsWith("table")) {
            assertDoesNotThrow(() -> kind.reading.read(bytes));
        } else {
            String message = assertThrows(Exception.class, () -> kind.reading.read(bytes))
                    .getMessage();
            assertTrue(message.contains("Latin-1") && message.contains("save it as UTF-8"), message);
        }
    }

    @Test
    void textFilesOfUsersAreDecodedInOnePlace() throws IOException {
        var found = new ArrayList<String>();
        for (String module : List.of("engine", "scenes", "editor", "lab", "app", "workshop")) {
            try (var files = Files.walk(Path.of(module, "src/main/java"))) {
                for (Path file : files.filter(Files::isRegularFile).toList()) {
                    String name = file.getFileName().toString();
                    if (OTHER_DECODING.matcher(Files.readString(file)).find() && !NO_USERS_FILES.contains(name)) {
                        found.add(name);
                    }
                }
            }
        }
        assertEquals(List.of(), found, "use TextFile");
    }
}
