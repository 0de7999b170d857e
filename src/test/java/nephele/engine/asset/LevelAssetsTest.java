package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LevelAssetsTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "/etc/passwd",
                "../x",
                "a/../../x",
                "..\\..\\x",
                "C:\\x",
                "\\\\host\\share",
                "con",
                "a/NUL.png",
                "com1.txt",
                "%2e%2e/x",
                "http://x/y",
                "a//b",
                "a/",
                "a./b",
                "./a",
                "a b",
                "a\u0000b",
                "ä",
                "-x",
                "x\n"
            })
    void namesThatMeanSomethingElseSomewhereAreRefused(String id) {
        assertNotNull(AssetId.rejectionReason(id));
        FolderAssets assets = new FolderAssets(folder);
        assertFalse(assets.exists(id));
        assertThrows(AssetException.class, () -> assets.bytes(id));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a", "a.png", "Textures/Brick-2_b.PNG", ".hidden", "console.png", "a..b"})
    void ordinaryNamesAreIds(String id) {
        assertNull(AssetId.rejectionReason(id));
    }

    @Test
    void theLevelsFolderComesBeforeTheCheckoutsAssets() throws IOException {
        Path levels = Files.createDirectories(folder.resolve("levels/samples"));
        Path shared = Files.createDirectories(folder.resolve("assets"));
        Files.writeString(shared.resolve("a.txt"), "shared");
        Files.writeString(shared.resolve("b.txt"), "shared");
        Files.writeString(levels.resolve("a.txt"), "own");
        LevelAssets assets = LevelAssets.beside(levels.resolve("x.json"));
        assertEquals("own", new String(assets.bytes("a.txt")));
        assertEquals("shared", new String(assets.bytes("b.txt")));
        AssetException missing = assertThrows(AssetException.class, () -> assets.bytes("c.txt"));
        assertTrue(missing.getMessage().startsWith("c.txt: there is no such file"));
    }

    @Test
    void linksThatLeaveTheFolderOrNeverEndAreRefused() throws IOException {
        Path inside = Files.createDirectories(folder.resolve("inside"));
        Files.writeString(folder.resolve("secret"), "s");
        Files.writeString(inside.resolve("real"), "r");
        Files.createSymbolicLink(inside.resolve("out"), folder.resolve("secret"));
        Files.createSymbolicLink(inside.resolve("fine"), inside.resolve("real"));
        Files.createSymbolicLink(inside.resolve("loop"), inside.resolve("loop"));
        FolderAssets assets = new FolderAssets(inside);
        assertEquals("r", new String(assets.bytes("fine")));
        assertTrue(assertThrows(AssetException.class, () -> assets.bytes("out"))
                .getMessage()
                .contains("leads out of"));
        assertThrows(AssetException.class, () -> assets.bytes("loop"));
        assertThrows(AssetException.class, () -> new FolderAssets(folder).bytes("inside"));
    }

    @Test
    void missingResourcesAreNamed() {
        AssetException missing = assertThrows(
                AssetException.class, () -> LevelAssets.inJar("samples/x.json").bytes("no.png"));
        assertEquals("no.png", missing.assetId());
    }
}
