package nephele.lab.technique;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.engine.level.Cloud;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;

/**
 * Exact pictures of skies that were traced before: a sky takes the tracer half a minute, and a change of how clouds are drawn
 * is judged against hundreds. A line of the file is the sky's key, the samples a pixel, and the picture.
 */
public final class TracedSkies {
    /** The name of the file, in this package's resources and where a report is made. */
    public static final String FILE = "traced-skies.csv";

    private static final int BLOCKS = TracedSky.WIDTH * TracedSky.HEIGHT;
    private static final int GREATEST = 0xffff;
    private static final Pattern NUMBER = Pattern.compile("-?\\d+\\.\\d+(?:[eE]-?\\d+)?");

    private final Map<String, Kept> kept = new HashMap<>();
    private final Path file;

    /** @param samples rays a pixel, both halves together */
    private record Kept(int samples, TracedSky sky) {}

    private TracedSkies(Path file) {
        this.file = file;
    }

    /** Returns the shipped pictures; what is traced besides is forgotten. */
    public static TracedSkies shipped() {
        return shipped(null);
    }

    private static TracedSkies shipped(Path file) {
        var skies = new TracedSkies(file);
        try (InputStream in = TracedSkies.class.getResourceAsStream(FILE)) {
            skies.add(new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .toList());
        } catch (IOException problem) {
            throw new UncheckedIOException(FILE, problem);
        }
        return skies;
    }

    /** Returns the shipped pictures and those in a file, to which those are added that are traced. */
    static TracedSkies in(Path file) throws IOException {
        TracedSkies skies = shipped(file);
        if (Files.exists(file)) {
            skies.add(TextFile.lines(file));
        }
        return skies;
    }

    private void add(List<String> lines) {
        for (String line : lines) {
            String[] fields = line.split(",");
            kept.put(fields[0], new Kept(Integer.parseInt(fields[1]), sky(Double.parseDouble(fields[2]), fields[3])));
        }
    }

    /** Returns the picture of a sky, kept with at least as many samples a pixel or else traced. */
    public TracedSky of(SkyView sky, int samples) {
        String key = key(sky);
        Kept found = kept.get(key);
        if (found != null && found.samples() >= samples) {
            return found.sky();
        }
        TracedSky traced = TracedSky.of(sky, samples);
        kept.put(key, new Kept(samples, traced));
        if (file != null) {
            append(key + "," + samples + "," + text(traced) + "\n");
        }
        return traced;
    }

    private void append(String line) {
        try {
            Files.writeString(file, line, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException problem) {
            throw new UncheckedIOException(AtomicFile.notWritten(file, problem));
        }
    }

    /** Returns the largest value, and after a comma in base 64 a bit for each block and 16 bits for each value of both halves, relative to the largest. */
    private static String text(TracedSky sky) {
        double scale = 0;
        for (LinearPicture half : List.of(sky.first(), sky.second())) {
            for (float value : half.rgb()) {
                scale = Math.max(scale, value);
            }
        }
        ByteBuffer bytes = ByteBuffer.allocate(Long.BYTES + 2 * 3 * BLOCKS * Short.BYTES);
        long cloudy = 0;
        for (int block = 0; block < BLOCKS; block++) {
            cloudy |= sky.cloudy()[block] ? 1L << block : 0;
        }
        bytes.putLong(cloudy);
        for (LinearPicture half : List.of(sky.first(), sky.second())) {
            for (float value : half.rgb()) {
                bytes.putShort((short) Math.round(value / scale * GREATEST));
            }
        }
        return scale + "," + Base64.getEncoder().encodeToString(bytes.array());
    }

    private static TracedSky sky(double scale, String text) {
        ByteBuffer bytes = ByteBuffer.wrap(Base64.getDecoder().decode(text));
        long bits = bytes.getLong();
        var cloudy = new boolean[BLOCKS];
        for (int block = 0; block < BLOCKS; block++) {
            cloudy[block] = (bits >> block & 1) != 0;
        }
        return new TracedSky(half(bytes, scale), half(bytes, scale), cloudy);
    }

    private static LinearPicture half(ByteBuffer bytes, double scale) {
        var rgb = new float[3 * BLOCKS];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (scale * (bytes.getShort() & GREATEST) / GREATEST);
        }
        return new LinearPicture(TracedSky.WIDTH, TracedSky.HEIGHT, rgb);
    }

    /** Returns 128 bits that depend on the sky's clouds and their pictures, its light and the view, all to six digits. */
    static String key(SkyView sky) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update(rounded(LevelJson.write(sky.level())).getBytes(StandardCharsets.UTF_8));
            Vec3 eye = sky.view().eye();
            Vec3 back = sky.view().back();
            String view = String.format(
                    Locale.ROOT,
                    "%.4f %.4f %.4f %.5f %.5f %.5f %.5f",
                    eye.x(),
                    eye.y(),
                    eye.z(),
                    back.x() + 0.0,
                    back.y() + 0.0,
                    back.z() + 0.0,
                    sky.view().projection().tanHalfHeight());
            digest.update(view.getBytes(StandardCharsets.UTF_8));
            for (Cloud cloud : sky.level().environment().clouds()) {
                cloud.density()
                        .assetId()
                        .ifPresent(id -> digest.update(sky.assets().bytes(id)));
            }
            return HexFormat.of().formatHex(digest.digest(), 0, 16);
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException("every Java has SHA-256", impossible);
        }
    }

    /** Other processors give sines another last digit. */
    private static String rounded(String text) {
        Matcher numbers = NUMBER.matcher(text);
        return numbers.replaceAll(number -> String.format(Locale.ROOT, "%.6g", Double.parseDouble(number.group())));
    }
}
