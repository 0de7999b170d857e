package nephele.engine.asset;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;

/** Pictures made by the test itself. */
public final class TestAssets implements AssetSource {
    public static final TestAssets NONE = new TestAssets();

    private final Map<String, byte[]> files = new HashMap<>();

    /** @param rgbAt 0xrrggbb of a pixel, row 0 at the top */
    public TestAssets picture(String id, int width, int height, IntBinaryOperator rgbAt) {
        return add(id, new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), rgbAt);
    }

    /** @param argbAt 0xaarrggbb of a pixel, row 0 at the top */
    public TestAssets seeThroughPicture(String id, int width, int height, IntBinaryOperator argbAt) {
        return add(id, new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB), argbAt);
    }

    /** The file of that name below {@code assets/}. */
    public TestAssets committed(String id) {
        try {
            files.put(id, Files.readAllBytes(Path.of("assets").resolve(id)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return this;
    }

    private TestAssets add(String id, BufferedImage image, IntBinaryOperator valueAt) {
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, valueAt.applyAsInt(x, y));
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
