package nephele.engine.asset;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Locale;

/** The supported picture formats, recognised by content; TGA, which has no signature, by its file name. */
enum PictureFormat {
    PNG,
    JPEG,
    BMP,
    TGA;

    private static final int BMP_HEADER = 14;
    private static final int BMP_VERSION_5_BYTES = 124;

    /** "MBED". */
    private static final int BMP_EMBEDDED = 0x4d424544;

    /** The width and height in the header. */
    record Size(long width, long height) {}

    /** A range of a file in bytes. */
    record Span(int offset, int length) {}

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
            case JPEG -> jpegSize(bytes);
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

    private static Size jpegSize(byte[] bytes) {
        JpegHeader header = JpegHeader.of(bytes);
        return header == null ? null : new Size(header.width(), header.height());
    }

    /** Returns the profile embedded in a BMP file with a header of version 5; {@code null} without one. */
    static byte[] bmpProfile(byte[] bytes) {
        ByteBuffer file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        boolean isEmbedded = bytes.length >= BMP_HEADER + BMP_VERSION_5_BYTES
                && file.getInt(BMP_HEADER) >= BMP_VERSION_5_BYTES
                && file.getInt(BMP_HEADER + 56) == BMP_EMBEDDED;
        int start = isEmbedded ? file.getInt(BMP_HEADER + 112) : 0;
        int size = isEmbedded ? file.getInt(BMP_HEADER + 116) : 0;
        boolean isThere = start > 0 && size > 0 && (long) BMP_HEADER + start + size <= bytes.length;
        return isThere ? Arrays.copyOfRange(bytes, BMP_HEADER + start, BMP_HEADER + start + size) : null;
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
