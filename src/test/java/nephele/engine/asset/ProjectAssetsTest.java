package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the names that a scene on disk may use beyond those of a level. */
class ProjectAssetsTest {
    @TempDir
    private Path outside;

    private Path scenes;
    private ProjectAssets assets;

    @BeforeEach
    void project() throws IOException {
        scenes = Files.createDirectories(outside.resolve("project/scenes/my own"))
                .getParent();
        Path models = Files.createDirectories(outside.resolve("project/models"));
        Files.writeString(outside.resolve("secret.3d"), "secret");
        Files.writeString(models.resolve("box.3d"), "above");
        Files.writeString(scenes.resolve("a.3d"), "beside");
        Files.writeString(scenes.resolve("my own/small box.3d"), "below");
        assets = ProjectAssets.around(scenes.resolve("x.xml"));
    }

    private String text(String name) {
        assertNull(assets.objection(name));
        assertTrue(assets.exists(name), name);
        return new String(assets.bytes(name));
    }

    @Test
    void filesOfItsFolderAndOfTheOneAboveAreFound() {
        assertEquals("beside", text("a.3d"));
        assertEquals("beside", text("../scenes/a.3d"));
        assertEquals("above", text("../models/box.3d"));
        assertEquals("above", text("my own/../../models/box.3d"));
        assertEquals("below", text("my own/small box.3d"));
        assertEquals("below", text("../scenes/my own/small box.3d"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "..",
                "../../secret.3d",
                "../../project/../secret.3d",
                "my own/../../../secret.3d",
                "/etc/passwd",
                "../../../../../../../etc/passwd",
                "C:/x.3d",
                "..\\models\\box.3d",
                "../models//box.3d",
                "../models/./box.3d",
                "../models/box.3d ",
                " ../models/box.3d",
                "../con .3d",
                "a b\u0000",
                "a b\n",
                "../-box.3d"
            })
    void otherNamesAreNeverLookedFor(String name) {
        assertNotNull(assets.objection(name));
        assertFalse(assets.exists(name));
        assertThrows(AssetException.class, () -> assets.bytes(name));
    }

    @Test
    void aFolderAboveThatIsTheWholeDiskIsNone() {
        var onTop = ProjectAssets.around(Path.of("").toAbsolutePath().getRoot().resolve("scenes/x.xml"));
        assertNotNull(onTop.objection("../etc/passwd"));
        assertNull(onTop.objection("../scenes/a.3d"));
    }

    @Test
    void linksOutOfTheProjectAndWhatIsNoFileAreRefused() throws IOException {
        Path models = outside.resolve("project/models");
        Files.createSymbolicLink(models.resolve("out.3d"), outside.resolve("secret.3d"));
        Files.createSymbolicLink(models.resolve("up"), outside);
        Files.createSymbolicLink(models.resolve("fine.3d"), models.resolve("box.3d"));
        Files.createSymbolicLink(models.resolve("loop.3d"), models.resolve("loop.3d"));
        assertEquals("above", text("../models/fine.3d"));
        for (String name : new String[] {"../models/out.3d", "../models/up/secret.3d"}) {
            var refused = assertThrows(AssetException.class, () -> assets.bytes(name));
            assertTrue(refused.getMessage().contains("leads out of"), refused.getMessage());
        }
        assertThrows(AssetException.class, () -> assets.bytes("../models/loop.3d"));
        assertFalse(assets.exists("../models"));
        assertThrows(AssetException.class, () -> assets.bytes("../models"));
    }

    /** The scenes' own folder may be a link; the files beside the link belong to the project. */
    @Test
    void theScenesOwnFolderMayBeALink() throws IOException {
        Path away = Files.createDirectories(outside.resolve("away/my own")).getParent();
        Files.writeString(away.resolve("my own/a b.3d"), "away");
        Path linked = Files.createSymbolicLink(outside.resolve("project/linked"), away);
        var project = ProjectAssets.around(linked.resolve("x.xml"));
        assertEquals("away", new String(project.bytes("my own/a b.3d")));
        assertEquals("above", new String(project.bytes("../models/box.3d")));
    }

    @Test
    void aFileThatIsTooLargeIsNotRead() throws IOException {
        try (var sparse = new RandomAccessFile(scenes.resolve("../huge.3d").toFile(), "rw")) {
            sparse.setLength(FolderAssets.MAX_FILE_BYTES + 1L);
        }
        var refused = assertThrows(AssetException.class, () -> assets.bytes("../huge.3d"));
        assertTrue(refused.getMessage().contains("is larger than"), refused.getMessage());
    }
}
