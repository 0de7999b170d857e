package nephele.engine.asset;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Text files of users: UTF-8, with or without the byte-order mark that some editors write, with any line ends. Text in
 * another encoding is refused by the encoding's name, never read as something else.
 */
public final class TextFile {
    /** Greatest size of a text file that has no limit of its own. */
    public static final int MOST_BYTES = 16 << 20;

    private static final int MARK_BYTES = 3;

    private TextFile() {}

    /** Bytes that are no UTF-8 text. The message completes "FILE can't be read: ". */
    public static final class NotUtf8 extends IOException {
        private static final long serialVersionUID = 1;

        private final int line;

        NotUtf8(int line, String message) {
            super(message);
            this.line = line;
        }

        /** Returns the line's number from 1. */
        public int line() {
            return line;
        }
    }

    /** Returns the lines of a file, a pipe or a device of at most {@link #MOST_BYTES}. */
    public static List<String> lines(Path file) throws IOException {
        try (var stream = Files.newInputStream(file)) {
            byte[] bytes = stream.readNBytes(MOST_BYTES + 1);
            if (bytes.length > MOST_BYTES) {
                throw new IOException("it has more than " + (MOST_BYTES >> 20) + " MiB; split it");
            }
            return text(bytes).lines().toList();
        }
    }

    /** Returns a file's text, without a byte-order mark. */
    public static String text(byte[] bytes) throws NotUtf8 {
        int start = textStart(bytes);
        CharBuffer decoded = CharBuffer.allocate(bytes.length - start);
        var decoder = StandardCharsets.UTF_8.newDecoder();
        CoderResult result = decoder.decode(ByteBuffer.wrap(bytes, start, bytes.length - start), decoded, true);
        String text = decoded.flip().toString();
        if (result.isError()) {
            int line = 1 + (int) text.chars().filter(c -> c == '\n').count();
            throw new NotUtf8(
                    line, "it is not UTF-8 but perhaps Latin-1 or Windows-1252 (line " + line + "); save it as UTF-8");
        }
        return text;
    }

    /**
     * Returns the index of the first byte after a byte-order mark, for readers that parse bytes.
     *
     * @throws NotUtf8 if the first bytes show UTF-16 or UTF-32, or are zero
     */
    public static int textStart(byte[] bytes) throws NotUtf8 {
        int first = at(bytes, 0);
        int second = at(bytes, 1);
        int third = at(bytes, 2);
        if (first == 0 && second == 0 && third == 0 && at(bytes, 3) == 0) {
            throw new NotUtf8(1, "it holds zero bytes instead of text; restore it from a copy");
        }
        boolean isMarked32 = first == 0xff && second == 0xfe && third == 0 && at(bytes, 3) == 0;
        if (isMarked32 || second == 0 && (first == 0 || third == 0)) {
            throw new NotUtf8(1, "it is UTF-32; save it as UTF-8");
        }
        if (first >= 0xfe || first == 0 || second == 0) {
            throw new NotUtf8(1, "it is UTF-16; save it as UTF-8");
        }
        return first == 0xef && second == 0xbb && third == 0xbf ? MARK_BYTES : 0;
    }

    /** Returns a byte, or a space's value beyond the end. */
    private static int at(byte[] bytes, int index) {
        return index < bytes.length ? bytes[index] & 0xff : ' ';
    }
}
