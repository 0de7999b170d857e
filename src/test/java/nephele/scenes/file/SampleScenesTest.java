package nephele.scenes.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.engine.model.shape.GeneratedName;
import nephele.host.terminal.CommandFailure;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.xml.Dialect;
import nephele.scenes.xml.PosedScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The sample scenes have no fault, and each invalid scene raises the message that it announces. */
class SampleScenesTest {
    private static final Path SCENES = Path.of("scenes");
    private static final Path INVALID = SCENES.resolve("invalid");

    static Stream<Path> valid() throws IOException {
        return Stream.concat(xmlFiles(SCENES), xmlFiles(SCENES.resolve("primitives")));
    }

    static Stream<Path> invalid() throws IOException {
        return xmlFiles(INVALID);
    }

    private static Stream<Path> xmlFiles(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("valid")
    void aSampleShowsEverythingThatItNames(Path file) {
        List<String> said = new ArrayList<>();
        var opened = OpenedScene.of(name(file), null, null, said::add);
        int models = load(opened.sources().scene());
        assertEquals(List.of(), said);
        assertTrue(models > 0);
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void anInvalidSampleSaysWhatItsCommentPromises(Path file) throws IOException {
        String promised = Files.readAllLines(file).stream()
                .map(String::strip)
                .filter(line -> line.startsWith("Says: ") || line.startsWith("Refused: "))
                .map(line -> line.replaceFirst(" -->$", ""))
                .collect(Collectors.joining("\n"));
        assertFalse(promised.isEmpty(), "it promises nothing");
        assertEquals(promised, String.join("\n", told(file)));
    }

    /** Returns the messages for a file, without the file's name. */
    private static List<String> told(Path file) {
        List<String> lines = new ArrayList<>();
        String prefix = slashed(file) + ":";
        try {
            var opened = OpenedScene.of(name(file), null, null, line -> lines.add("Says: " + without(prefix, line)));
            load(opened.sources().scene());
        } catch (CommandFailure refused) {
            lines.add("Refused: " + without(prefix, refused.getMessage()));
        }
        return lines;
    }

    private static String without(String prefix, String line) {
        assertTrue(line.startsWith(prefix), line);
        return line.substring(prefix.length());
    }

    @Test
    void theSampleIsThereWithShipAndStarsWhereverOneStands() {
        List<String> said = new ArrayList<>();
        var opened = OpenedScene.of(SceneName.SAMPLE, SceneName.SAMPLE_ENTITY, SceneName.SAMPLE_BACKGROUND, said::add);
        assertTrue(load(opened.sources().scene()) > 50);
        assertTrue(load(opened.sources().entity()) > 10);
        assertNotNull(opened.sources().background());
        assertEquals(List.of(), said);
    }

    @Test
    void everyShapeIsThereInBothDialects() throws IOException {
        for (String shape : List.of("plane", "box", "cone", "sphere", "cylinder", "torus", "teapot", "path")) {
            Path folder = SCENES.resolve("primitives");
            assertEquals(Dialect.WORLD, dialect(folder.resolve(shape + ".xml")));
            assertEquals(Dialect.SCENE, dialect(folder.resolve(shape + "-scene.xml")));
        }
        assertTrue(GeneratedName.shape("torus_1_0.4_48_24.3d", ignored -> null).isPresent());
    }

    private static Dialect dialect(Path file) {
        return OpenedScene.of(name(file), null, null, line -> {}).scene().dialect();
    }

    @Test
    void aNameIsATitle() {
        assertEquals("Solar system", SceneName.SAMPLE.title());
        assertEquals("two-worlds", new SceneName("a\\b/two-worlds.XML").stem());
        assertEquals("Two worlds", new SceneName("a\\b/two-worlds.XML").title());
    }

    /** Reads every mesh and picture. Returns the number of models. */
    private static int load(Source source) {
        var posed = PosedScene.of(source.scene());
        for (int i = 0; i < posed.modelCount(); i++) {
            source.files().mesh(posed.model(i));
            if (posed.model(i).texture() != null) {
                source.files().picture(posed.model(i));
            }
        }
        return posed.modelCount();
    }

    private static SceneName name(Path file) {
        return new SceneName(slashed(file));
    }

    private static String slashed(Path file) {
        return file.toString().replace('\\', '/');
    }
}
