package nephele.engine.cloud.field;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.SplittableRandom;
import javax.imageio.ImageIO;
import nephele.engine.asset.AssetSource;

/** Pictures of clouds as files. */
final class TestPictures {
    /** An asset source in which every file is one grey picture with noise and black places. */
    static final AssetSource COVERAGE = always(png(coverage()));

    private TestPictures() {}

    static AssetSource always(byte[] file) {
        return new AssetSource() {
            @Override
            public byte[] bytes(String assetId) {
                return file;
            }

            @Override
            public boolean exists(String assetId) {
                return true;
            }
        };
    }

    static byte[] png(BufferedImage picture) {
        var out = new ByteArrayOutputStream();
        try {
            ImageIO.write(picture, "png", out);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return out.toByteArray();
    }

    private static BufferedImage coverage() {
        var random = new SplittableRandom(11);
        var picture = new BufferedImage(37, 21, BufferedImage.TYPE_BYTE_GRAY);
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                picture.getRaster().setSample(x, y, 0, Math.max(0, random.nextInt(-128, 256)));
            }
        }
        return picture;
    }
}
