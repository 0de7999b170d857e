package nephele.engine.asset;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/** Writes PNG files (third edition); equal samples give equal bytes. */
public final class PngEncoder {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /** The filter that stores differences from the row above, section 9.2: smooth heights become small numbers. */
    private static final byte UP = 2;

    /** Colour types of the PNG specification, table 11.1, by the number of channels. */
    private static final int[] COLOURS = {0, 0, 4, 2, 6};

    private PngEncoder() {}

    /** Returns the file of a picture of 8 bits, which decodes to the same samples. */
    public static byte[] file(Picture picture) {
        if (picture.bitsPerChannel() != 8) {
            throw new IllegalArgumentException("pictures of 8 bits alone");
        }
        return file(
                new PngFile.Header(picture.width(), picture.height(), 8, COLOURS[picture.channels()], 0),
                picture.samples());
    }

    /**
     * Returns the file of samples.
     *
     * @param colour as in {@link PngFile.Header}
     * @param samples rows from the top without padding, 16-bit ones with the high byte first
     */
    static byte[] file(PngFile.Header header, byte[] samples) {
        ByteBuffer head = ByteBuffer.allocate(13);
        head.putInt(header.width()).putInt(header.height());
        head.put((byte) header.bitDepth()).put((byte) header.colour()).put(new byte[3]);
        ByteArrayOutputStream file = new ByteArrayOutputStream(samples.length / 2 + 100);
        file.writeBytes(SIGNATURE);
        chunk(file, "IHDR", head.array());
        chunk(file, "IDAT", deflated(filtered(samples, header.height())));
        chunk(file, "IEND", new byte[0]);
        return file.toByteArray();
    }

    private static byte[] filtered(byte[] samples, int rows) {
        int stride = samples.length / rows;
        byte[] filtered = new byte[samples.length + rows];
        for (int row = 0, at = 0; row < rows; row++) {
            filtered[at++] = UP;
            for (int i = row * stride; i < (row + 1) * stride; i++) {
                filtered[at++] = (byte) (samples[i] - (row == 0 ? 0 : samples[i - stride]));
            }
        }
        return filtered;
    }

    private static byte[] deflated(byte[] bytes) {
        Deflater deflater = new Deflater(Deflater.BEST_SPEED);
        try {
            deflater.setInput(bytes);
            deflater.finish();
            ByteArrayOutputStream all = new ByteArrayOutputStream(bytes.length / 2 + 100);
            byte[] part = new byte[1 << 16];
            while (!deflater.finished()) {
                all.write(part, 0, deflater.deflate(part));
            }
            return all.toByteArray();
        } finally {
            deflater.end();
        }
    }

    private static void chunk(ByteArrayOutputStream file, String type, byte[] content) {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 sum = new CRC32();
        sum.update(name);
        sum.update(content);
        file.writeBytes(ByteBuffer.allocate(4).putInt(content.length).array());
        file.writeBytes(name);
        file.writeBytes(content);
        file.writeBytes(ByteBuffer.allocate(4).putInt((int) sum.getValue()).array());
    }
}
