package nephele.workshop.art;

import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Writes Truevision TGA files of 24 bits a pixel, uncompressed, from the lowest row, as games' tools write them. */
final class TgaFile {
    private static final int HEADER_BYTES = 18;
    private static final byte TRUE_COLOUR = 2;
    private static final byte BITS = 24;

    private TgaFile() {}

    static byte[] written(BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        ByteBuffer file = ByteBuffer.allocate(HEADER_BYTES + 3 * width * height).order(ByteOrder.LITTLE_ENDIAN);
        file.put(2, TRUE_COLOUR).putShort(12, (short) width).putShort(14, (short) height);
        file.put(16, BITS).position(HEADER_BYTES);
        for (int y = height - 1; y >= 0; y--) {
            for (int x = 0; x < width; x++) {
                int rgb = picture.getRGB(x, y);
                file.put((byte) rgb).put((byte) (rgb >> 8)).put((byte) (rgb >> 16));
            }
        }
        return file.array();
    }
}
