package nephele.lab.trade;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.json.LevelFile;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The oracle's pictures are kept under keys that change with everything that the pictures depend on. */
@Execution(ExecutionMode.CONCURRENT)
class TradeSiteTest {
    private static final OpenedLevel CAMERAS = new LevelName("levels/samples/cameras.json").open();
    private static final TradeSite.Extent SMALL = new TradeSite.Extent(4, 2, 1);

    @TempDir
    Path folder;

    private float[] traced(String camera, TradeSite.Extent extent) {
        try (var site = new TradeSite(
                CAMERAS,
                TradeView.of(CAMERAS, camera, extent.aspect()),
                extent,
                folder,
                new PrintStream(OutputStream.nullOutputStream()))) {
            return site.reference().rgb();
        }
    }

    private int kept() throws IOException {
        try (var files = Files.list(folder)) {
            return (int) files.count();
        }
    }

    @Test
    void oneFileForOneViewHoweverOftenItIsMade() throws IOException {
        List<String> cameras =
                CAMERAS.level().cameras().stream().map(camera -> camera.id()).toList();
        float[] first = traced(cameras.get(0), SMALL);
        assertArrayEquals(first, traced(cameras.get(0), SMALL));
        assertEquals(1, kept(), "the same view is found again");
        traced(cameras.get(1), SMALL);
        assertEquals(2, kept(), "another camera is another view");
        traced(cameras.get(0), new TradeSite.Extent(4, 2, 2));
        assertEquals(3, kept(), "more rays are another picture");
    }

    @Test
    void aPictureThatIsPaintedAnewMakesAnotherLevel() {
        var textured = new LevelName("levels/samples/material-textures.json").open();
        assertEquals(TracedPictures.levelHash(textured), TracedPictures.levelHash(with(textured, 0)));
        assertNotEquals(TracedPictures.levelHash(textured), TracedPictures.levelHash(with(textured, 1)));
        assertNotEquals(TracedPictures.levelHash(textured), TracedPictures.levelHash(CAMERAS));
    }

    /** @param change is added to the last byte of every asset */
    private static OpenedLevel with(OpenedLevel opened, int change) {
        AssetSource changed = new AssetSource() {
            @Override
            public byte[] bytes(String assetId) {
                byte[] bytes = opened.assets().bytes(assetId).clone();
                bytes[bytes.length - 1] += (byte) change;
                return bytes;
            }

            @Override
            public boolean exists(String assetId) {
                return opened.assets().exists(assetId);
            }
        };
        return new OpenedLevel(new LevelFile.Opened(opened.file(), opened.level(), changed, Optional.empty()));
    }

    /** The key changes with the content of a class in a nested folder, although times and sizes are equal. */
    @Test
    void otherCodeHasAnotherKey() throws IOException {
        Path nested = Files.createDirectories(folder.resolve("a/b")).resolve("C.class");
        Files.writeString(nested, "one");
        String before = Provenance.codeHash(List.of(folder));
        assertEquals(before, Provenance.codeHash(List.of(folder, folder.resolve("none"))));
        var time = Files.getLastModifiedTime(nested);
        Files.writeString(nested, "two");
        Files.setLastModifiedTime(nested, time);
        assertNotEquals(before, Provenance.codeHash(List.of(folder)));
        assertNotEquals(Provenance.codeHash(List.of(folder)), Provenance.codeHash(List.of(nested)));
        assertEquals(Provenance.codeHash(), Provenance.codeHash());
    }
}
