package nephele.app.trade;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** A PFM as {@link nephele.engine.render.Capture#pfm} writes it: little-endian RGB floats, the bottom row first. */
final class RadianceFile {
    private static final int HEADER_LINES = 3;

    private RadianceFile() {}

    static float[] read(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        int start = 0;
        for (int line = 0; line < HEADER_LINES && start < bytes.length; start++) {
            line += bytes[start] == '\n' ? 1 : 0;
        }
        if (!new String(bytes, 0, start, StandardCharsets.US_ASCII).matches("PF\n\\d+ \\d+\n-1\\.0\n")) {
            throw new IOException(file + ": is no picture of this program's; delete it");
        }
        float[] rgb = new float[(bytes.length - start) / Float.BYTES];
        ByteBuffer.wrap(bytes, start, bytes.length - start)
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(rgb);
        return rgb;
    }
}
