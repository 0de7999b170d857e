package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The files on the disk after a scene is imported as a level. */
@Execution(ExecutionMode.CONCURRENT)
class ImportCommandTest {
    private static final String SCENE = "<scene>\n<models><model file=\"box_2_3.3d\"/>"
            + "<model file=\"own/tri.3d\" texture=\"own/t.png\"/>\n<model file=\"nowhere.3d\"/></models></scene>";
    private static final String TURNING =
            "<group><rotate y=\"1\" time=\"9\"/><models><model file=\"box_2_3.3d\"/></models></group>\n";
    private static final String TRIANGLE = "0 0 0\n1 0 0\n0 1 0\n";

    @TempDir
    Path folder;

    private Path scene(String text) throws IOException {
        Path from = Files.createDirectories(folder.resolve("from/own")).getParent();
        Files.writeString(from.resolve("own/tri.3d"), TRIANGLE);
        Files.copy(Path.of("assets/textures/plaster.png"), from.resolve("own/t.png"));
        return Files.writeString(from.resolve("scene.xml"), text);
    }

    private static Captured imported(Path scene, Path level) {
        return Captured.run("import", scene.toString(), "--out", level.toString());
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> folder.relativize(file).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void theLevelsFilesLieBesideItAndItIsWithoutErrors() throws IOException {
        Path level = folder.resolve("to/level.json");
        Captured answer = imported(scene(SCENE), level);
        assertEquals(0, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("scene.xml:3: nowhere.3d"), answer.err());
        assertEquals(List.of("box_2_3.3d", "level.json", "own/t.png", "own/tri.3d"), names(level.getParent()));
        Captured checked = Captured.run("check", level.toString());
        assertEquals(0, checked.exitCode(), checked.out());
        Level read = LevelFile.read(level);
        assertEquals(2, read.models().size());
        assertEquals("scene", read.name());
    }

    /** Every written file is listed, and equal warnings are one line with their number. */
    @Test
    void whatWasWrittenAndWhatWasLeftOutIsListed() throws IOException {
        Path level = folder.resolve("to/level.json");
        Captured answer = imported(scene(SCENE.replace("<models>", TURNING + TURNING + "<models>")), level);
        List<String> written = answer.out()
                .lines()
                .filter(line -> line.startsWith("written: "))
                .map(line -> level.getParent()
                        .toAbsolutePath()
                        .relativize(Path.of(line.substring(9)).toAbsolutePath())
                        .toString()
                        .replace('\\', '/'))
                .sorted()
                .toList();
        assertEquals(names(level.getParent()), written);
        List<String> stays = answer.err()
                .lines()
                .filter(line -> line.contains("a level's models stay"))
                .toList();
        assertEquals(1, stays.size(), answer.err());
        assertTrue(stays.get(0).endsWith("(2 times)"), answer.err());
    }

    @Test
    void besideTheSceneNothingIsWrittenThatIsThere() throws IOException {
        Path scene = scene(SCENE);
        assertEquals(0, imported(scene, folder.resolve("from/level.json")).exitCode());
        assertEquals(
                List.of("box_2_3.3d", "level.json", "own/t.png", "own/tri.3d", "scene.xml"), names(scene.getParent()));
        assertEquals(TRIANGLE, Files.readString(scene.resolveSibling("own/tri.3d")));
        assertEquals(0, imported(scene, folder.resolve("from/level.json")).exitCode());
        assertEquals(
                List.of("box_2_3.3d", "level.json", "level.json.bak", "own/t.png", "own/tri.3d", "scene.xml"),
                names(scene.getParent()));
    }

    @Test
    void whatHasTheNameAlreadyStaysAsItIs() throws IOException {
        Path to = Files.createDirectories(folder.resolve("to/own")).getParent();
        byte[] other = {1, 2, 3};
        Files.write(to.resolve("box_2_3.3d"), other);
        Files.write(to.resolve("own/t.png"), other);
        assertEquals(0, imported(scene(SCENE), to.resolve("level.json")).exitCode());
        assertArrayEquals(other, Files.readAllBytes(to.resolve("box_2_3.3d")));
        assertArrayEquals(other, Files.readAllBytes(to.resolve("own/t.png")));
        Level level = LevelFile.read(to.resolve("level.json"));
        assertEquals("box_2_3-2.3d", level.models().get(0).file());
        assertEquals("own/t-2.png", level.materials().get(1).texture());
        assertEquals(
                0, Captured.run("check", to.resolve("level.json").toString()).exitCode());
    }

    @Test
    void aBrokenSceneNamesFileAndLineAndLeavesNothing() throws IOException {
        for (String broken : List.of(
                "<scene>\n<models><model file='a",
                "<scene>\n<models/></scene>",
                "<scene><models>\n<model file='nowhere.3d'/></models></scene>",
                "\n<!DOCTYPE scene>")) {
            Path to = folder.resolve("to");
            Path file = Files.writeString(folder.resolve("broken.xml"), broken);
            Captured answer = imported(file, to.resolve("level.json"));
            assertEquals(1, answer.exitCode(), answer.err());
            assertTrue(answer.err().contains("broken.xml:"), answer.err());
            assertFalse(answer.err().contains("Exception"), answer.err());
            assertFalse(Files.exists(to), "something was written");
        }
    }

    @Test
    void aSceneThatMakesNoLevelLeavesNoMeshes() throws IOException {
        Path to = folder.resolve("to/level.json");
        Path flat = scene("<scene><group>\n<scale x='1' y='1'/><models><model file='box_2_3.3d'/>"
                + "<model file='own/tri.3d' texture='own/t.png'/></models></group></scene>");
        assertEquals(1, imported(flat, to).exitCode());
        assertFalse(Files.exists(to.getParent()), "something was written");
    }

    @Test
    void aLevelThatCannotBeSavedLeavesNoMeshes() throws IOException {
        Path taken = Files.createDirectories(folder.resolve("to/level.json"));
        Captured answer = imported(scene(SCENE), taken);
        assertEquals(3, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("level.json"), answer.err());
        assertEquals(List.of(), names(taken.getParent()));
        assertFalse(Files.exists(taken.resolveSibling("own")), "a folder was made");
    }

    /** The import stops at the first model that exceeds the limit, before the others are made. */
    @Test
    void aSceneOfTooManyTrianglesIsToldByItsLineAndLeavesNothing() throws IOException {
        StringBuilder models = new StringBuilder();
        for (int tessellation = 10; tessellation < 512; tessellation += 10) {
            models.append("\n<model file='bezier_").append(tessellation).append(".3d'/>");
        }
        Path to = folder.resolve("to/level.json");
        Captured answer = imported(scene("<scene><models>" + models + "</models></scene>"), to);
        assertEquals(1, answer.exitCode());
        assertTrue(answer.err().contains("scene.xml:6: makes no level: with bezier_50.3d"), answer.err());
        assertFalse(Files.exists(to.getParent()), "something was written");
    }

    /** A generated mesh named in another folder, as course projects do, is written beside the level. */
    @Test
    void aGeneratedMeshOfAnotherFolderLiesBesideTheLevel() throws IOException {
        Path level = folder.resolve("to/level.json");
        Path scene = scene("<scene><models><model file='../my models/box_2_3.3d'/></models></scene>");
        Captured answer = imported(scene, level);
        assertEquals(0, answer.exitCode(), answer.err());
        assertEquals(List.of("box_2_3.3d", "level.json"), names(level.getParent()));
    }

    /** A level does not look for files in the folder above, so they are copied. */
    @Test
    void filesOfTheFolderAboveAreCopiedUnderNamesThatALevelMayGive() throws IOException {
        Path scene = scene("<scene><models><model file='../my models/a b.3d' texture='../my models/own t.png'/>"
                + "<model file='own/a b.3d'/></models></scene>");
        Path models = Files.createDirectories(folder.resolve("my models"));
        Files.writeString(models.resolve("a b.3d"), TRIANGLE);
        Files.copy(scene.resolveSibling("own/t.png"), models.resolve("own t.png"));
        Files.writeString(scene.resolveSibling("own/a b.3d"), TRIANGLE.replace('1', '2'));
        Path level = folder.resolve("to/level.json");
        Captured answer = imported(scene, level);
        assertEquals(0, answer.exitCode(), answer.err());
        assertEquals(List.of("a_b-2.3d", "a_b.3d", "level.json", "own_t.png"), names(level.getParent()));
        assertArrayEquals(
                Files.readAllBytes(models.resolve("own t.png")), Files.readAllBytes(level.resolveSibling("own_t.png")));
        Level read = LevelFile.read(level);
        assertEquals("a_b.3d", read.models().get(0).file());
        assertEquals("a_b-2.3d", read.models().get(1).file());
        assertEquals(0, Captured.run("check", level.toString()).exitCode());
    }

    @Test
    void theHintHowToPlayItCanBeTyped() throws IOException {
        Path scene = scene(SCENE);
        Path plain = folder.resolve("to/level.json");
        assertTrue(imported(scene, plain).out().endsWith(" nephele play " + plain + System.lineSeparator()));
        Path spaced = folder.resolve("my levels/a level.json");
        assertTrue(imported(scene, spaced).out().endsWith(" nephele play \"" + spaced + "\"" + System.lineSeparator()));
    }

    /** A scene of the jar is found by its name; no file here has it. */
    @Test
    void aSceneOfTheJarIsFoundByItsName() throws IOException {
        Path level = folder.resolve("to/level.json");
        Captured answer = imported(Path.of("lighthouse.xml"), level);
        assertEquals(0, answer.exitCode(), answer.err());
        assertEquals("lighthouse", LevelFile.read(level).name());
        Captured checked = Captured.run("check", level.toString());
        assertEquals(0, checked.exitCode(), checked.out());
    }

    @Test
    void aMissingSceneAndAWrongEndingAreTold() throws IOException {
        Captured missing = imported(folder.resolve("none.xml"), folder.resolve("level.json"));
        assertEquals(1, missing.exitCode());
        assertTrue(missing.err().contains("none.xml: it can't be read: there is no such file"), missing.err());
        assertEquals(2, imported(scene(SCENE), folder.resolve("level.txt")).exitCode());
        assertEquals(2, Captured.run("import", "a.xml").exitCode());
    }

    @Test
    void whatTheGameHasIsNotCopied() throws IOException {
        String own = "<scene><models><model file=\"own/tri.3d\" texture=\"textures/plaster.png\"/></models></scene>";
        Path level = folder.resolve("deep/er/level.json");
        Path scene = scene(own);
        assertEquals(0, imported(scene, level).exitCode());
        assertEquals(List.of("level.json", "own/tri.3d"), names(level.getParent()));
        Path noFolder = Files.writeString(folder.resolve("file"), "");
        assertEquals(3, imported(scene, noFolder.resolve("level.json")).exitCode());
    }
}
