package nephele.engine.render;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;

/** Pictures made by the test itself. */
final class TestAssets implements AssetSource {
    static final TestAssets NONE = new TestAssets();

    private final Map<String, byte[]> files = new HashMap<>();

    /** @param rgbAt 0xrrggbb of a pixel, row 0 at the top */
    TestAssets picture(String id, int width, int height, IntBinaryOperator rgbAt) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, rgbAt.applyAsInt(x, y));
            }
        }
        try (ByteArrayOutputStream png = new ByteArrayOutputStream()) {
            ImageIO.write(image, "png", png);
            files.put(id, png.toByteArray());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return this;
    }

    @Override
    public byte[] bytes(String assetId) throws AssetException {
        if (!exists(assetId)) {
            throw new AssetException(assetId, "is missing", "add it to the test");
        }
        return files.get(assetId);
    }

    @Override
    public boolean exists(String assetId) {
        return files.containsKey(assetId);
    }

    /** Keeps bakes out of the user's own cache. */
    @Override
    public Optional<Path> cacheFolder() {
        return Optional.of(Path.of("build", "test-cache"));
    }
}
