package nephele.editor.save;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import nephele.editor.text.EditorRefusal;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Language;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.PackageContent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A package brings a level with all its files to another place, and a hostile one brings nothing. */
@Execution(ExecutionMode.CONCURRENT)
class LevelPackageTest {
    private static final String LEVEL = "{\"format\": \"nephele-level\", \"version\": 1}";

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"samples/empty.json", "samples/models.json", "samples/material-textures.json"})
    void aLevelArrivesWithItsFiles(String name) throws IOException, EditorRefusal {
        LevelFile.Opened opened = LevelFile.open("levels/" + name);
        Path zip = folder.resolve("a.zip");
        LevelPackage.export(zip, "room.json", opened.level(), opened.assets());
        byte[] first = Files.readAllBytes(zip);
        Path link = Files.createSymbolicLink(folder.resolve("link.zip"), zip);
        LevelPackage.export(link, "room.json", opened.level(), opened.assets());
        assertArrayEquals(first, Files.readAllBytes(zip), "equal levels give equal packages");
        assertTrue(Files.isSymbolicLink(link));
        LevelFile.Opened played = LevelFile.open(zip.toString());
        assertEquals(opened.level(), played.level(), "a package plays as it is");
        for (String id : NamedAssets.of(opened.level(), opened.assets())) {
            assertArrayEquals(opened.assets().bytes(id), played.assets().bytes(id), id);
        }
        Path level = LevelPackage.extract(zip, folder.resolve("there"));
        assertEquals(folder.resolve("there").resolve("room.json"), level);
        assertEquals(opened.level(), LevelFile.read(level));
        var ids = NamedAssets.of(opened.level(), opened.assets());
        for (String id : ids) {
            byte[] bytes = Files.readAllBytes(folder.resolve("there").resolve(id));
            assertArrayEquals(opened.assets().bytes(id), bytes, id);
        }
        assertEquals(!name.contains("empty"), !ids.isEmpty());
        assertFalse(ids.contains("box_0.8_1.3d"), "a generated mesh is no file");
    }

    @Test
    void theBuffersOfAMeshAreItsLevelsFiles() throws IOException, EditorRefusal {
        Files.writeString(
                folder.resolve("a.gltf"),
                """
                {"asset": {"version": "2.0"}, "buffers": [{"uri": "a.bin", "byteLength": 4}]}""");
        Files.write(folder.resolve("a.bin"), new byte[4]);
        var level = DraftLevel.of("\"models\": [{\"id\": \"m\", \"file\": \"a.gltf\"}]");
        var assets = LevelAssets.beside(folder.resolve("x.json"));
        assertEquals(List.of("a.bin", "a.gltf"), List.copyOf(NamedAssets.of(level, assets)));
    }

    @Test
    void aMissingFileIsNamedAndNothingWritten() {
        var level = DraftLevel.of("\"models\": [{\"id\": \"m\", \"file\": \"none.obj\"}]");
        var assets = LevelAssets.beside(folder.resolve("x.json"));
        Path zip = folder.resolve("a.zip");
        var told = assertThrows(EditorRefusal.class, () -> LevelPackage.export(zip, "x.json", level, assets));
        assertTrue(told.getMessage().contains("none.obj"), told.getMessage());
        assertFalse(Files.exists(zip));
    }

    @Test
    void entriesThatTheLevelDoesNotNeedAreLeftOut() throws IOException, EditorRefusal {
        Path zip = zip("room.json", LEVEL, "virus.exe", "x", "sub/", "");
        LevelPackage.extract(zip, folder.resolve("there"));
        try (var all = Files.list(folder.resolve("there"))) {
            assertEquals(
                    List.of("room.json"),
                    all.map(each -> each.getFileName().toString()).toList());
        }
    }

    static Stream<List<String>> hostile() {
        return Stream.of(
                List.of("../evil.json", LEVEL),
                List.of("room.json", LEVEL, "a/../../evil.png", "x"),
                List.of("room.json", LEVEL, "/etc/evil", "x"),
                List.of("room.json", LEVEL, "C:\\evil.png", "x"),
                List.of("room.json", LEVEL, "..", "x"),
                List.of("room.json", LEVEL, "con.png", "x"),
                List.of("room.json", LEVEL, "nul\0.png", "x"),
                List.of("room.json", LEVEL, "a.png", "x", "A.png", "y"),
                List.of("room.json", LEVEL, "x".repeat(200) + ".png", "x"),
                List.of("room.json", LEVEL, "sub/../", ""),
                List.of("room.json", "{\"format\": \"nephele-level\", \"version\": 99}"),
                List.of("room.json", "no level"),
                List.of("a.json", LEVEL, "b.json", LEVEL),
                List.of("readme.txt", "x"),
                List.of());
    }

    @ParameterizedTest
    @MethodSource("hostile")
    void aHostilePackageLeavesNothing(List<String> entries) throws IOException {
        assertRefused(zip(entries.toArray(String[]::new)));
    }

    @Test
    void aBrokenOrEndlessPackageLeavesNothing() throws IOException {
        Path text = folder.resolve("text.zip");
        Files.writeString(text, "no zip");
        assertRefused(text);
        byte[] whole = Files.readAllBytes(zip("room.json", LEVEL));
        Path torn = folder.resolve("torn.zip");
        for (int length = 0; length < whole.length; length += 7) {
            Files.write(torn, Arrays.copyOf(whole, length));
            assertRefused(torn);
        }
        assertRefused(folder.resolve("missing.zip"));
        assertRefused(bomb());
        String[] many = new String[2 * (PackageContent.MOST_ENTRIES + 1)];
        for (int i = 0; i < many.length; i += 2) {
            many[i] = "f" + i;
            many[i + 1] = "";
        }
        assertRefused(zip(many));
    }

    @Test
    void aFolderWithFilesIsNotOverwritten() throws IOException {
        Path there = Files.createDirectory(folder.resolve("there"));
        Files.writeString(there.resolve("mine.txt"), "mine");
        Path zip = zip("room.json", LEVEL);
        var told = assertThrows(EditorRefusal.class, () -> LevelPackage.extract(zip, there));
        assertEquals(SaveText.PACKAGE_TARGET.with(there), told.words());
        assertEquals("mine", Files.readString(there.resolve("mine.txt")));
    }

    private void assertRefused(Path zip) throws IOException {
        Path target = folder.resolve("there");
        var told = assertThrows(EditorRefusal.class, () -> LevelPackage.extract(zip, target));
        assertTrue(told.words().in(Language.PT_PT).contains(zip.toString()), told.getMessage());
        var unplayed = assertThrows(LevelFormatException.class, () -> LevelFile.open(zip.toString()));
        assertTrue(unplayed.getMessage().matches("(?s)" + Pattern.quote(zip + ": ") + ".*new export.*"));
        try (var left = Files.list(folder)) {
            assertTrue(left.allMatch(each -> each.toString().endsWith(".zip")), "something was left");
        }
    }

    private Path zip(String... namesAndContents) throws IOException {
        Path zip = folder.resolve("hostile.zip");
        try (var out = new ZipOutputStream(Files.newOutputStream(zip))) {
            for (int i = 0; i < namesAndContents.length; i += 2) {
                out.putNextEntry(new ZipEntry(namesAndContents[i]));
                out.write(namesAndContents[i + 1].getBytes(StandardCharsets.UTF_8));
                out.closeEntry();
            }
        }
        return zip;
    }

    /** Returns a small file with an entry that unpacks to more than is permitted. */
    private Path bomb() throws IOException {
        Path zip = folder.resolve("bomb.zip");
        try (var out = new ZipOutputStream(Files.newOutputStream(zip))) {
            out.setLevel(1);
            out.putNextEntry(new ZipEntry("bomb.png"));
            byte[] part = new byte[1 << 20];
            for (int bytes = 0; bytes <= PackageContent.MOST_ENTRY_BYTES; bytes += part.length) {
                out.write(part);
            }
            out.closeEntry();
        }
        return zip;
    }
}
