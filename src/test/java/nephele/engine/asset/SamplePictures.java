package nephele.engine.asset;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import javax.imageio.ImageIO;

/** Generated picture files for tests. */
public final class SamplePictures {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};

    private SamplePictures() {}

    /** Returns a valid PNG of noise with rows of all five filters. */
    public static byte[] png(int width, int height, int bitDepth, int colour, long seed) {
        int channels = new PngFile.Header(1, 1, 8, colour, 0).channels();
        int rowBytes = (width * channels * bitDepth + 7) / 8;
        byte[] rows = new byte[height * (rowBytes + 1)];
        new Random(seed).nextBytes(rows);
        for (int y = 0; y < height; y++) {
            rows[y * (rowBytes + 1)] = (byte) (y % 5);
        }
        return png(header(width, height, bitDepth, colour, 0), chunk("IDAT", deflated(rows)));
    }

    /** Returns a PNG of signature, header, these chunks and the end chunk. */
    public static byte[] png(byte[] header, byte[]... chunks) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(SIGNATURE);
        out.writeBytes(header);
        for (byte[] chunk : chunks) {
            out.writeBytes(chunk);
        }
        out.writeBytes(chunk("IEND", new byte[0]));
        return out.toByteArray();
    }

    public static byte[] header(int width, int height, int bitDepth, int colour, int interlace) {
        return chunk(
                "IHDR",
                ByteBuffer.allocate(13)
                        .putInt(width)
                        .putInt(height)
                        .put((byte) bitDepth)
                        .put((byte) colour)
                        .put((byte) 0)
                        .put((byte) 0)
                        .put((byte) interlace)
                        .array());
    }

    public static byte[] chunk(String type, byte[] content) {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 sum = new CRC32();
        sum.update(name);
        sum.update(content);
        return ByteBuffer.allocate(content.length + 12)
                .putInt(content.length)
                .put(name)
                .put(content)
                .putInt((int) sum.getValue())
                .array();
    }

    public static byte[] deflated(byte[] bytes) {
        Deflater deflater = new Deflater();
        deflater.setInput(bytes);
        deflater.finish();
        byte[] out = new byte[bytes.length + bytes.length / 100 + 64];
        int length = deflater.deflate(out);
        deflater.end();
        return java.util.Arrays.copyOf(out, length);
    }

    /** Returns an image as written by {@code javax.imageio}. */
    public static byte[] written(BufferedImage image, String format) {
        try (ByteArrayOutputStream out = new ByteArrayOutputStream()) {
            if (!ImageIO.write(image, format, out)) {
                throw new IllegalArgumentException("cannot write " + format);
            }
            return out.toByteArray();
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** Returns a TGA file of 2 × 2 pixels and two colours; {@code type} 1 plain, 9 run-length encoded. */
    public static byte[] paletteTga(int type, byte[] indices) {
        byte[] colours = {1, 2, 3, 4, 5, 6};
        byte[] content = ByteBuffer.allocate(colours.length + indices.length)
                .put(colours)
                .put(indices)
                .array();
        return ByteBuffer.wrap(tga(type, 2, 2, 8, content))
                .put(1, (byte) 1)
                .put(5, (byte) 2)
                .put(7, (byte) 24)
                .array();
    }

    /** Returns a TGA file of true-colour pixels; {@code type} 2 plain, 10 run-length encoded. */
    public static byte[] tga(int type, int width, int height, int bits, byte[] content) {
        return ByteBuffer.allocate(18 + content.length)
                .order(java.nio.ByteOrder.LITTLE_ENDIAN)
                .put(2, (byte) type)
                .putShort(12, (short) width)
                .putShort(14, (short) height)
                .put(16, (byte) bits)
                .put(17, (byte) (0x20 | (bits == 32 ? 8 : 0)))
                .put(18, content)
                .array();
    }
}
