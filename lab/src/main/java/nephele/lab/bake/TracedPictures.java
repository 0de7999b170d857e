package nephele.lab.bake;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Supplier;
import nephele.engine.math.Hash64;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.TraceSettings;
import nephele.engine.render.Capture;

/**
 * A cache of the oracle's pictures, in a folder, in the format of {@link Capture#pfm}. A picture is traced again only
 * after a change of something that it depends on.
 *
 * @param code a hash of the code that traces
 */
public record TracedPictures(Path folder, String code) {
    private static final int HEADER_LINES = 3;

    /**
     * Returns linear radiance, bottom row first.
     *
     * @param level a hash of the level and its assets: {@link LevelHash#key}
     * @param trace traces the picture if the folder does not hold it
     */
    public LinearPicture picture(String level, Pinhole eye, TraceSettings settings, Supplier<float[]> trace) {
        String size = settings.width() + "x" + settings.height();
        long key = Hash64.of(
                String.join(" ", code, level, size, settings.samples() + "/" + settings.seed(), eye.toString()));
        Path file = folder.resolve("oracle-" + Long.toHexString(key) + ".pfm");
        try {
            if (!Files.exists(file)) {
                Capture.pfm(trace.get(), settings.width(), settings.height(), file);
            }
            return new LinearPicture(settings.width(), settings.height(), read(file));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static float[] read(Path file) throws IOException {
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
