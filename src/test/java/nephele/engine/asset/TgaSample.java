package nephele.engine.asset;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.IntBinaryOperator;
import java.util.function.IntUnaryOperator;

/** A kind of true-colour TGA file that tests write. */
public record TgaSample(int bits, Packing packing, Origin origin) {
    private static final int HEADER_BYTES = 18;
    private static final int LONGEST_PACKET = 128;

    /** Plain pixels or run-length packets, which this writer ends at each row. */
    public enum Packing {
        RAW,
        RUNS
    }

    /** The first row of the file: the picture's lowest, as most programs write it, or its highest. */
    public enum Origin {
        LOWER_LEFT,
        UPPER_LEFT
    }

    /** @param rgbAt returns 0xrrggbb of a pixel, row 0 at the top */
    public byte[] written(int width, int height, IntBinaryOperator rgbAt) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(header(width, height));
        for (int row = 0; row < height; row++) {
            int y = origin == Origin.UPPER_LEFT ? row : height - 1 - row;
            if (packing == Packing.RAW) {
                for (int x = 0; x < width; x++) {
                    out.writeBytes(pixel(rgbAt.applyAsInt(x, y)));
                }
            } else {
                writePackets(out, width, x -> rgbAt.applyAsInt(x, y));
            }
        }
        return out.toByteArray();
    }

    private byte[] header(int width, int height) {
        int alphaBits = bits == 32 ? 8 : bits == 16 ? 1 : 0;
        return ByteBuffer.allocate(HEADER_BYTES)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(2, (byte) (packing == Packing.RAW ? 2 : 10))
                .putShort(12, (short) width)
                .putShort(14, (short) height)
                .put(16, (byte) bits)
                .put(17, (byte) (alphaBits | (origin == Origin.UPPER_LEFT ? 0x20 : 0)))
                .array();
    }

    /** Writes runs of equal pixels as one pixel each, and the pixels between two runs as they are. */
    private void writePackets(ByteArrayOutputStream out, int width, IntUnaryOperator rgbAt) {
        int x = 0;
        while (x < width) {
            int run = runAt(x, width, rgbAt);
            int length = run;
            while (run == 1 && x + length < width && length < LONGEST_PACKET && runAt(x + length, width, rgbAt) == 1) {
                length++;
            }
            out.write(run > 1 ? 0x80 | (run - 1) : length - 1);
            for (int i = 0; i < (run > 1 ? 1 : length); i++) {
                out.writeBytes(pixel(rgbAt.applyAsInt(x + i)));
            }
            x += length;
        }
    }

    private static int runAt(int x, int width, IntUnaryOperator rgbAt) {
        int length = 1;
        while (x + length < width && length < LONGEST_PACKET && rgbAt.applyAsInt(x + length) == rgbAt.applyAsInt(x)) {
            length++;
        }
        return length;
    }

    /** Returns blue, green, red and, with 32 bits, alpha; or 16 bits as alpha, five red, five green and five blue. */
    private byte[] pixel(int rgb) {
        int red = rgb >> 16 & 0xff;
        int green = rgb >> 8 & 0xff;
        int blue = rgb & 0xff;
        if (bits == 16) {
            int packed = 0x8000 | five(red) << 10 | five(green) << 5 | five(blue);
            return new byte[] {(byte) packed, (byte) (packed >> 8)};
        }
        return bits == 24
                ? new byte[] {(byte) blue, (byte) green, (byte) red}
                : new byte[] {(byte) blue, (byte) green, (byte) red, (byte) 0xff};
    }

    private static int five(int eight) {
        return (eight * 31 + 127) / 255;
    }
}
