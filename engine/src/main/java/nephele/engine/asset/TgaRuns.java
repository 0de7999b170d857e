package nephele.engine.asset;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The length of the pixels in a TGA file, plain or in packets (Truevision TGA 2.0, "Run-length encoded images"). */
final class TgaRuns {
    private static final int HEADER_BYTES = 18;
    private static final int FIRST_ENCODED_TYPE = 9;
    private static final int LAST_ENCODED_TYPE = 11;

    private TgaRuns() {}

    /** Returns true if the file holds the pixels of its size: plain ones at least, packets exactly. */
    static boolean fit(byte[] bytes) {
        ByteBuffer header = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        long left = (long) (header.getShort(12) & 0xffff) * (header.getShort(14) & 0xffff);
        int pixelBytes = bytesOf(bytes[16]);
        long at = begin(bytes);
        if (bytes[2] < FIRST_ENCODED_TYPE || bytes[2] > LAST_ENCODED_TYPE) {
            return at + pixelBytes * left <= bytes.length;
        }
        while (left > 0 && at < bytes.length) {
            int packet = bytes[(int) at];
            int pixels = (packet & 0x7f) + 1;
            at += 1 + (long) pixelBytes * (packet < 0 ? 1 : pixels);
            left -= pixels;
        }
        return left == 0 && at <= bytes.length;
    }

    /** Returns the offset of the pixels: after the header, the image id and the palette. */
    static int begin(byte[] bytes) {
        int colours = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getShort(5) & 0xffff;
        return HEADER_BYTES + (bytes[0] & 0xff) + (bytes[1] == 1 ? colours * bytesOf(bytes[7]) : 0);
    }

    private static int bytesOf(byte bits) {
        return ((bits & 0xff) + 7) / 8;
    }
}
