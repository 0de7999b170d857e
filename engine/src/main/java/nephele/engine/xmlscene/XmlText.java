package nephele.engine.xmlscene;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;

/** Decodes bytes to text: UTF-8, with or without a byte-order mark, and nothing else. */
final class XmlText {
    private static final String REMEDY = "save it as UTF-8 text";

    private XmlText() {}

    static String of(byte[] bytes, SceneWarnings warnings) {
        if (bytes.length > XmlSceneFile.MOST_BYTES) {
            int mebibytes = XmlSceneFile.MOST_BYTES >> 20;
            throw warnings.error(0, "the file has more than " + mebibytes + " MiB", "split the scene");
        }
        int first = bytes.length > 0 ? bytes[0] & 0xff : ' ';
        int second = bytes.length > 1 ? bytes[1] & 0xff : ' ';
        if (first >= 0xfe || first == 0 || second == 0) {
            throw warnings.error(1, "the file is not UTF-8 but UTF-16 or no text at all", REMEDY);
        }
        int start = first == 0xef && second == 0xbb && bytes.length > 2 && (bytes[2] & 0xff) == 0xbf ? 3 : 0;
        return decoded(ByteBuffer.wrap(bytes, start, bytes.length - start), warnings);
    }

    private static String decoded(ByteBuffer bytes, SceneWarnings warnings) {
        CharBuffer text = CharBuffer.allocate(bytes.remaining());
        CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(bytes, text, true);
        String read = text.flip().toString();
        if (result.isError()) {
            throw warnings.error(lineAt(read, read.length()), "this is not UTF-8", REMEDY);
        }
        int zero = read.indexOf('\0');
        if (zero >= 0) {
            throw warnings.error(lineAt(read, zero), "the file holds zero bytes instead of text", "restore it");
        }
        return read;
    }

    private static int lineAt(String text, int position) {
        return 1 + (int) text.chars().limit(position).filter(c -> c == '\n').count();
    }
}
