package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import nephele.engine.model.Mesh;
import nephele.engine.model.file.ModelFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class GenerateCommandTest {
    @TempDir
    Path folder;

    private Captured generate(String line) {
        return Captured.run(Stream.of(("generate " + line).split(" "))
                .map(word -> word.equals("OUT") ? out().toString() : word)
                .toArray(String[]::new));
    }

    private Path out() {
        return folder.resolve("made/out.3d");
    }

    private Mesh made() throws IOException {
        return ModelFiles.read("out.3d", Files.readAllBytes(out()), name -> null);
    }

    @ParameterizedTest
    @CsvSource({
        "plane 2 3 OUT, 18",
        "plane 2 3 --two-sided OUT, 36",
        "box 2 3 OUT, 108",
        "cone 1 2 4 3 OUT, 24",
        "sphere 1 8 8 OUT, 112",
        "cylinder 1 2 8 OUT, 32",
        "torus 1 0.3 8 6 OUT, 96",
        "patch assets/models/teapot.patch 10 OUT, 6320",
        "tree grass 7 OUT, 440"
    })
    void everyShapeIsWritten(String line, int triangles) throws IOException {
        var answer = generate(line);
        assertEquals(0, answer.exitCode(), answer.err());
        assertEquals("", answer.out() + answer.err());
        assertEquals(triangles, made().triangleCount());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "box 2 0 OUT",
                "box 2 1000000 OUT",
                "box 2 OUT",
                "box 2 3 4 OUT",
                "box nan 3 OUT",
                "box 2 3 out.obj",
                "cone 0 2 4 3 OUT",
                "blob 1 OUT",
                "box",
                "box 2 3 --two-sided OUT",
                "patch x.patch OUT",
                "patch assets/models/teapot.patch 512 OUT",
                "patch assets/models/teapot.patch 0 OUT",
                "box 1 512 OUT",
                "tree oak OUT",
                "tree palm 1 OUT",
                "tree boulder 1 OUT",
                "rock boulder x OUT"
            })
    void whatCannotBeMadeIsWrongUsageAndWritesNothing(String line) {
        var answer = generate(line);
        assertEquals(2, answer.exitCode());
        assertTrue(answer.err().startsWith("nephele generate: "), answer.err());
        assertFalse(Files.exists(out()));
    }

    @Test
    void aBrokenPatchFileIsAnInputErrorWithItsLine() throws IOException {
        var patch = Files.writeString(folder.resolve("a.patch"), "1\n0,1\n");
        var answer = generate("patch " + patch + " 4 OUT");
        assertEquals(1, answer.exitCode());
        assertTrue(answer.err().startsWith(patch + ":2: "), answer.err());
        assertEquals(1, generate("patch none.patch 4 OUT").exitCode());
    }

    @Test
    void whatWasThereStaysWhenItCannotBeReplaced() throws IOException {
        Files.createDirectories(out());
        assertEquals(3, generate("box 2 3 OUT").exitCode());
        assertTrue(Files.isDirectory(out()));
        assertArrayEquals(new String[0], out().toFile().list());
    }

    @Test
    void anUnknownKindIsToldTheKinds() {
        assertTrue(generate("tree palm 1 OUT").err().contains("oak, birch, fir, cypress, bush, fern, grass"));
        assertTrue(generate("rock oak 1 OUT").err().contains("boulder, ledge"));
    }

    @Test
    void helpSaysWhatTheNumbersMean() {
        String help = Captured.run("generate", "--help").out();
        for (String word : new String[] {"LENGTH", "RADIUS", "HEIGHT", "TUBE", "DIVISIONS", "SLICES", "STACKS"}) {
            assertTrue(help.contains("\n" + word), help);
        }
    }
}
