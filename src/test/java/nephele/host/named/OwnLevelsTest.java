package nephele.host.named;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OwnLevelsTest {
    @TempDir
    Path folder;

    private void write(String... names) throws IOException {
        for (String name : names) {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            Files.writeString(file, "");
        }
    }

    /** A folder that nobody may read hides the levels of no other one; who runs tests as root may read it. */
    @Test
    void levelsOfTheFolderComeBeforeThoseOfItsFolders() throws IOException {
        write("b.json", "A.zip", "picture.png", ".hidden.json");
        write("unpacked/room.json", "replays/b.json", "deep/er/room.json");
        Path secret = Files.createDirectory(folder.resolve("a-secret"));
        secret.toFile().setReadable(false);
        try {
            List<String> names = LevelCatalogue.in(folder).stream()
                    .map(level -> LevelCatalogue.nameIn(folder, level))
                    .toList();
            assertEquals(
                    List.of("A.zip", "b.json", Path.of("unpacked/room.json").toString()), names);
        } finally {
            secret.toFile().setReadable(true);
        }
        assertEquals(List.of(), LevelCatalogue.in(folder.resolve("none")));
    }

    /** A level is broken for the list, too, if a file that it names is missing: it could not be played. */
    @Test
    void aLevelWithoutItsTextureIsBroken() throws IOException {
        Path level = folder.resolve("room.json");
        Files.writeString(
                level,
                """
                {"format": "nephele-level", "version": 1, "player": {"feet": [0, 0, 0]},
                 "materials": [{"id": "wall", "texture": "textures/none.png"}],
                 "solids": [{"id": "floor", "kind": "box", "material": "wall", "centre": [0, -1, 0], "size": [9, 2, 9]}]}
                """);
        assertEquals(
                List.of("materials[0].texture: textures/none.png: there is no such file; "
                        + "put it into the level's folder or into assets/ (names are case-sensitive)"),
                LevelSummary.checked(new LevelName(level.toString())).problems());
    }
}
