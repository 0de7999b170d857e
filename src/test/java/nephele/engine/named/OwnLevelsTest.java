package nephele.engine.named;

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
            List<String> names = OwnLevels.in(folder).stream()
                    .map(level -> OwnLevels.nameIn(folder, level))
                    .toList();
            assertEquals(
                    List.of("A.zip", "b.json", Path.of("unpacked/room.json").toString()), names);
        } finally {
            secret.toFile().setReadable(true);
        }
        assertEquals(List.of(), OwnLevels.in(folder.resolve("none")));
    }
}
