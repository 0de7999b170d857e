package nephele.engine.asset;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import nephele.engine.asset.PictureFormat.Span;

/**
 * The chunks of a PNG file that determine its stored pixels (PNG, third edition, section 5); {@link PngColours} reads
 * those that say what colours they are. All others are skipped unread: compressed texts can expand to any size.
 *
 * @param palette position of the {@code PLTE} contents, {@code null} without them
 * @param transparency position of the {@code tRNS} contents, {@code null} without them
 * @param pixelData positions of the {@code IDAT} contents in {@code bytes}
 */
record PngFile(byte[] bytes, Header header, Span palette, Span transparency, List<Span> pixelData) {
    private static final int SIGNATURE_BYTES = 8;
    private static final int HEADER_BYTES = 13;
    private static final int FIRST_AFTER_HEADER = SIGNATURE_BYTES + 8 + HEADER_BYTES + 4;
    private static final int IHDR = 0x49484452;
    private static final int PLTE = 0x504c5445;
    private static final int IDAT = 0x49444154;
    private static final int IEND = 0x49454e44;
    private static final int TRNS = 0x74524e53;

    /** The IHDR chunk, section 11.2.1; {@code colour} 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA. */
    record Header(int width, int height, int bitDepth, int colour, int interlace) {
        int channels() {
            return switch (colour) {
                case 2 -> 3;
                case 4 -> 2;
                case 6 -> 4;
                default -> 1;
            };
        }
    }

    static PngFile of(byte[] bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        Header header = header(buffer);
        Span palette = null;
        Span transparency = null;
        List<Span> pixelData = new ArrayList<>();
        for (int at = FIRST_AFTER_HEADER; ; ) {
            int length = chunkLength(buffer, at);
            int type = buffer.getInt(at + 4);
            Span content = new Span(at + 8, length);
            switch (type) {
                case TRNS -> transparency = content;
                case PLTE -> palette = content;
                case IDAT -> pixelData.add(content);
                default -> {
                    if (type != IEND && (type & 0x20000000) == 0) {
                        throw new IOException("unknown critical chunk");
                    }
                }
            }
            if (type == TRNS || (type & 0x20000000) == 0) {
                checkSum(buffer, content);
            }
            if (type == IEND) {
                return new PngFile(bytes, header, palette, transparency, pixelData);
            }
            at += length + 12;
        }
    }

    /** Returns what colours the pixels are. */
    PngColours colours() throws PictureDecoder.UnreadablePicture {
        return PngColours.of(ByteBuffer.wrap(bytes), FIRST_AFTER_HEADER);
    }

    private static int chunkLength(ByteBuffer buffer, int at) throws IOException {
        if (at + 12 > buffer.limit()) {
            throw new IOException("cut off");
        }
        int length = buffer.getInt(at);
        if (length < 0 || length > buffer.limit() - at - 12) {
            throw new IOException("cut off");
        }
        return length;
    }

    /**
     * Reads the header, which is the first chunk and the only one of its kind, so the size checked is the size used.
     */
    private static Header header(ByteBuffer buffer) throws IOException {
        Span content = new Span(SIGNATURE_BYTES + 8, HEADER_BYTES);
        if (chunkLength(buffer, SIGNATURE_BYTES) != HEADER_BYTES || buffer.getInt(SIGNATURE_BYTES + 4) != IHDR) {
            throw new IOException("no header");
        }
        checkSum(buffer, content);
        int at = content.offset();
        if (buffer.getShort(at + 10) != 0) {
            throw new IOException("unknown compression or filter method");
        }
        return new Header(
                buffer.getInt(at), buffer.getInt(at + 4), buffer.get(at + 8), buffer.get(at + 9), buffer.get(at + 12));
    }

    /** Checks a chunk's CRC, which covers type and content. */
    private static void checkSum(ByteBuffer buffer, Span content) throws IOException {
        CRC32 sum = new CRC32();
        sum.update(buffer.array(), content.offset() - 4, content.length() + 4);
        if ((int) sum.getValue() != buffer.getInt(content.offset() + content.length())) {
            throw new IOException("bad check sum");
        }
    }
}
