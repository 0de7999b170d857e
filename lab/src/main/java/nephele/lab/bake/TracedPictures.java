package nephele.lab.bake;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Basis;
import nephele.engine.math.Hash64;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.render.Capture;
import nephele.engine.scene.View;
import nephele.host.named.OpenedLevel;

/**
 * A cache of reference pictures, in a folder, in the format of {@link Capture#pfm}. A picture is traced again only
 * after a change of something that it depends on.
 *
 * @param code a hash of the code that traces
 */
public record TracedPictures(Path folder, String code) {
    private static final Pattern STRING = Pattern.compile("\"([^\"\\\\]+)\"");

    private static final int HEADER_LINES = 3;

    /**
     * Returns linear radiance, bottom row first.
     *
     * @param level a hash of the level and its assets: {@link TracedPictures#levelHash}
     * @param trace traces the picture if the folder does not hold it
     */
    public LinearPicture picture(String level, Pinhole eye, TraceSettings settings, Supplier<float[]> trace) {
        String size = settings.width() + "x" + settings.height();
        long key = Hash64.of(
                String.join(" ", code, level, size, settings.samples() + "/" + settings.seed(), eye.toString())
                        + settings.light().key());
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

    /**
     * Returns a hash that is equal for equal levels with equal assets. An asset that is missing or not a file counts as
     * empty.
     */
    public static String levelHash(OpenedLevel opened) {
        Level level = opened.level();
        long hash = Hash64.of(LevelJson.write(level));
        // A level may have a hundred thousand solids, and solids name only materials, never assets.
        String naming = LevelJson.write(level.with(level.materials(), List.of()));
        var ids = STRING.matcher(naming)
                .results()
                .map((MatchResult string) -> string.group(1))
                .filter(id ->
                        AssetId.rejectionReason(id) == null && opened.assets().exists(id))
                .distinct()
                .toList();
        for (String id : ids) {
            hash = Hash64.combine(hash, Hash64.of(content(id, opened.assets())));
        }
        return Long.toHexString(hash);
    }

    private static byte[] content(String id, AssetSource assets) {
        try {
            return assets.bytes(id);
        } catch (AssetException unreadable) {
            return new byte[0];
        }
    }

    /**
     * Returns the facts by name.
     *
     * @param seconds simulated time
     * @param kind what the values of the picture are
     */
    public static Map<String, String> facts(
            OpenedLevel opened, double seconds, Pinhole eye, TraceSettings settings, String kind) {
        return Map.of(
                "level", levelHash(opened),
                "seconds", Double.toString(seconds),
                "camera", eye.toString(),
                "samples", Integer.toString(settings.samples()),
                "seed", Long.toString(settings.seed()),
                "colours", kind + settings.light().key(),
                "tracer", Integer.toString(ReferencePicture.VERSION));
    }

    /** Converts a view of the engine to the reference tracer's pinhole camera. */
    public static Pinhole pinhole(View view) {
        var projection = view.projection();
        return new Pinhole(
                view.eye(),
                new Basis(view.right(), view.up(), view.back()),
                projection.tanHalfWidth(),
                projection.tanHalfHeight(),
                projection.nearMetres(),
                projection.farMetres());
    }
}
