package nephele.engine.measure;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Reads the pictures that were given to the authors' evaluator; see flip_figures.py beside them. */
final class Pfm {
    private Pfm() {}

    static LinearPicture resource(String name) throws IOException {
        byte[] bytes;
        try (var in = Pfm.class.getResourceAsStream(name)) {
            bytes = in.readAllBytes();
        }
        int line = 0;
        int start = 0;
        while (line < 3) {
            line += bytes[start++] == '\n' ? 1 : 0;
        }
        String[] words = new String(bytes, 0, start, StandardCharsets.US_ASCII).split("\\s+");
        float[] rgb = new float[(bytes.length - start) / 4];
        ByteBuffer.wrap(bytes, start, bytes.length - start)
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(rgb);
        return new LinearPicture(Integer.parseInt(words[1]), Integer.parseInt(words[2]), rgb);
    }
}
