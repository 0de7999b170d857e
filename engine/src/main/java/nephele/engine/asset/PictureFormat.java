package nephele.engine.asset;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Locale;

/** The supported picture formats, recognised by content; TGA, which has no signature, by its file name. */
enum PictureFormat {
    PNG,
    JPEG,
    BMP,
    TGA;

    /** The width and height in the header. */
    record Size(long width, long height) {}

    /** Returns the format, or {@code null} if it is unknown. */
    static PictureFormat of(String assetId, byte[] bytes) {
        if (startsWith(bytes, 0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a)) {
            return PNG;
        }
        if (startsWith(bytes, 0xff, 0xd8, 0xff)) {
            return JPEG;
        }
        if (startsWith(bytes, 'B', 'M')) {
            return BMP;
        }
        return assetId.toLowerCase(Locale.ROOT).endsWith(".tga") ? TGA : null;
    }

    /** Reads the size from the header only; {@code null} if that is truncated or has no size. */
    Size size(byte[] bytes) {
        ByteBuffer big = ByteBuffer.wrap(bytes);
        ByteBuffer little = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        return switch (this) {
            case PNG -> bytes.length < 33 ? null : new Size(unsigned(big.getInt(16)), unsigned(big.getInt(20)));
            case JPEG -> jpegSize(big);
            case BMP -> bmpSize(little);
            case TGA -> bytes.length < 18 ? null : new Size(little.getShort(12) & 0xffff, little.getShort(14) & 0xffff);
        };
    }

    private static Size bmpSize(ByteBuffer little) {
        if (little.limit() < 26) {
            return null;
        }
        if (little.getInt(14) == 12) {
            return new Size(little.getShort(18) & 0xffff, little.getShort(20) & 0xffff);
        }
        return new Size(little.getInt(18), Math.abs((long) little.getInt(22)));
    }

    /** Reads the marker segments up to the frame header (ITU-T T.81, B.1.1.4 and B.2.2). */
    private static Size jpegSize(ByteBuffer big) {
        int at = 2;
        while (at + 9 <= big.limit()) {
            int marker = big.getShort(at) & 0xffff;
            if (marker >>> 8 != 0xff) {
                return null;
            }
            boolean frame =
                    marker >= 0xffc0 && marker <= 0xffcf && marker != 0xffc4 && marker != 0xffc8 && marker != 0xffcc;
            if (frame) {
                return new Size(big.getShort(at + 7) & 0xffff, big.getShort(at + 5) & 0xffff);
            }
            at += marker == 0xffff ? 1 : 2 + (big.getShort(at + 2) & 0xffff);
        }
        return null;
    }

    private static long unsigned(int value) {
        return value & 0xffffffffL;
    }

    private static boolean startsWith(byte[] bytes, int... signature) {
        if (bytes.length < signature.length) {
            return false;
        }
        for (int i = 0; i < signature.length; i++) {
            if ((bytes[i] & 0xff) != signature[i]) {
                return false;
            }
        }
        return true;
    }
}
