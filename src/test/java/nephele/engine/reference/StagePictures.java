package nephele.engine.reference;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;

/** The pictures of a {@link Stage}. */
final class StagePictures implements AssetSource {
    private final Map<String, byte[]> files = new HashMap<>();

    /** @param argbAt 0xaarrggbb of a pixel, row 0 at the top */
    void put(String id, int width, int height, IntBinaryOperator argbAt) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, argbAt.applyAsInt(x, y));
            }
        }
        try (ByteArrayOutputStream png = new ByteArrayOutputStream()) {
            ImageIO.write(image, "png", png);
            files.put(id, png.toByteArray());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
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
}
