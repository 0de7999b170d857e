package nephele.engine.scene.light.bake;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.Layer;
import nephele.engine.scene.light.bake.IndirectLight.SkyLight;

/**
 * The encoding of baked light, nine bytes a point before it is deflated. The radiance is a common factor, the greatest
 * channel on a logarithmic scale, and three parts of it, as in the pictures of Ward (1991, "Real pixels"), whose
 * exponents would jump where this factor is smooth. Errors: 0.34 % of the greatest channel, 1/254 in a component of the
 * direction of the moments, 2.2 % of their luminance.
 */
public final class IndirectLightFile {
    private static final byte[] MAGIC = "NLIGHT01".getBytes(StandardCharsets.US_ASCII);

    private static final int MOST_LAYERS = 64;
    private static final int CONTENT_BYTES = 32;

    /** Steps of the factor for each power of two; the value 1 is in the middle, 0 is black. */
    private static final int FACTOR_STEPS = 256;

    private static final int FACTOR_OF_ONE = 1 << 15;

    /** Steps of the moments' luminance, relative to that of the radiance, which it is at least a quarter of. */
    private static final int LUMINANCE_STEPS = 16;

    private static final double LEAST_LUMINANCE = 0.25;

    private static final float[] WEIGHTS = {0.2126f, 0.7152f, 0.0722f};

    private IndirectLightFile() {}

    /**
     * The head of a file.
     *
     * @param levelFile the name of the level's file, without its folder
     * @param content {@link LightKey#content}
     */
    public record Head(String levelFile, byte[] content) {}

    /** Returns the head of a file of this kind, of which the first kibibyte suffices; empty if it is another kind. */
    public static Optional<Head> head(byte[] bytes) {
        try (DataInputStream from = new DataInputStream(new ByteArrayInputStream(bytes))) {
            boolean isOurs = Arrays.equals(from.readNBytes(MAGIC.length), MAGIC);
            from.readInt();
            Head head = new Head(from.readUTF(), from.readNBytes(CONTENT_BYTES));
            return isOurs && head.content().length == CONTENT_BYTES ? Optional.of(head) : Optional.empty();
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** Returns true if no byte behind the sum has changed since the file was written. */
    public static boolean isWhole(byte[] bytes) {
        int rest = MAGIC.length + Integer.BYTES;
        return bytes.length > rest && sum(bytes, rest) == ByteBuffer.wrap(bytes).getInt(MAGIC.length);
    }

    /** Returns the bytes of a file; equal values have equal bytes. */
    public static byte[] encode(Head head, LightMapLayout layout, IndirectLight light) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
        try (DataOutputStream to = new DataOutputStream(bytes)) {
            to.writeUTF(head.levelFile());
            to.write(head.content());
            to.writeLong(SkyVisibilityFile.placement(layout));
            to.writeUTF(light.sky().name());
            to.writeInt(light.layers().size());
            for (Layer layer : light.layers()) {
                to.writeUTF(layer.name());
                to.writeUTF(layer.course().name());
            }
            try (DataOutputStream body = new DataOutputStream(new DeflaterOutputStream(bytes, deflater))) {
                for (Layer layer : light.layers()) {
                    for (LightSamples samples : samplesOf(layer)) {
                        write(samples, body);
                    }
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            deflater.end();
        }
        byte[] rest = bytes.toByteArray();
        return ByteBuffer.allocate(MAGIC.length + Integer.BYTES + rest.length)
                .put(MAGIC)
                .putInt(sum(rest, 0))
                .put(rest)
                .array();
    }

    private static List<LightSamples> samplesOf(Layer layer) {
        List<LightSamples> all = new ArrayList<>(List.of(layer.texels(), layer.vertices()));
        all.addAll(layer.grounds());
        return all;
    }

    private static int sum(byte[] bytes, int from) {
        CRC32 crc = new CRC32();
        crc.update(bytes, from, bytes.length - from);
        return (int) crc.getValue();
    }

    /**
     * Decodes a file; empty if the bytes are damaged or no light for this layout. Takes memory for what the bytes hold
     * only.
     *
     * @param statics the baked static geometry, models split
     * @param groundPoints of each terrain
     */
    public static Optional<IndirectLight> decode(
            LightMapLayout layout, StaticShapes statics, List<Integer> groundPoints, byte[] bytes) {
        if (head(bytes).isEmpty() || !isWhole(bytes)) {
            return Optional.empty();
        }
        int rest = MAGIC.length + Integer.BYTES;
        try (DataInputStream from = new DataInputStream(new ByteArrayInputStream(bytes, rest, bytes.length - rest));
                InflaterInputStream body = new InflaterInputStream(from)) {
            from.readUTF();
            from.readNBytes(CONTENT_BYTES);
            if (from.readLong() != SkyVisibilityFile.placement(layout)) {
                return Optional.empty();
            }
            SkyLight sky = SkyLight.valueOf(from.readUTF());
            int count = from.readInt();
            if (count < 1 || count > MOST_LAYERS) {
                return Optional.empty();
            }
            List<String> names = new ArrayList<>();
            List<Course> courses = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                names.add(from.readUTF());
                courses.add(Course.valueOf(from.readUTF()));
            }
            List<Layer> layers = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                LightSamples texels = read(body, layout.width() * layout.height());
                LightSamples vertices = read(body, statics.models().vertexCount());
                List<LightSamples> grounds = new ArrayList<>();
                for (int points : groundPoints) {
                    grounds.add(read(body, points));
                }
                layers.add(new Layer(names.get(i), courses.get(i), texels, vertices, grounds));
            }
            return body.read() < 0 ? Optional.of(new IndirectLight(sky, layers)) : Optional.empty();
        } catch (IOException | IllegalArgumentException damaged) {
            return Optional.empty();
        }
    }

    /** Writes each component of all points behind each other, as differences between consecutive values. */
    private static void write(LightSamples samples, DataOutputStream body) throws IOException {
        int points = samples.points();
        short[] factors = new short[points];
        byte[][] planes = new byte[LightSamples.CHANNELS + LightSamples.MOMENTS][points];
        double[] steps = factorSteps();
        float[] rgb = new float[LightSamples.CHANNELS];
        for (int point = 0; point < points; point++) {
            float greatest = 0;
            for (int channel = 0; channel < rgb.length; channel++) {
                greatest = Math.max(greatest, samples.radiance()[LightSamples.CHANNELS * point + channel]);
            }
            int factor = factor(greatest);
            factors[point] = (short) factor;
            float scale = scale(factor, steps);
            for (int channel = 0; factor > 0 && channel < rgb.length; channel++) {
                double part = samples.radiance()[LightSamples.CHANNELS * point + channel] / (double) greatest;
                int code = (int) Math.round(255 * Math.max(0, part));
                planes[channel][point] = (byte) code;
                rgb[channel] = scale * (code / 255f);
            }
            if (factor > 0) {
                writeMoments(samples.moments(), point, luminance(rgb, 0), planes);
            }
        }
        SkyVisibilityFile.write(factors, body);
        for (byte[] plane : planes) {
            byte previous = 0;
            for (int point = 0; point < points; point++) {
                byte value = plane[point];
                plane[point] -= previous;
                previous = value;
            }
            body.write(plane);
        }
    }

    private static void writeMoments(float[] moments, int point, float radiance, byte[][] planes) {
        int at = LightSamples.MOMENTS * point;
        double luminance = moments[at + 3];
        if (!(luminance > 0)) {
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            long code = Math.round(127 * moments[at + axis] / luminance);
            planes[LightSamples.CHANNELS + axis][point] = (byte) Math.max(-127, Math.min(127, code));
        }
        double octaves = StrictMath.log(luminance / radiance / LEAST_LUMINANCE) / StrictMath.log(2);
        long code = 1 + Math.round(LUMINANCE_STEPS * octaves);
        planes[LightSamples.CHANNELS + 3][point] = (byte) Math.max(1, Math.min(255, code));
    }

    private static LightSamples read(InputStream body, int points) throws IOException {
        short[] factors = SkyVisibilityFile.values(body, points);
        byte[][] planes = new byte[LightSamples.CHANNELS + LightSamples.MOMENTS][];
        for (int i = 0; i < planes.length; i++) {
            planes[i] = body.readNBytes(points);
            if (planes[i].length != points) {
                throw new IOException("too short");
            }
            for (int point = 1; point < points; point++) {
                planes[i][point] += planes[i][point - 1];
            }
        }
        LightSamples samples = LightSamples.black(points);
        double[] steps = factorSteps();
        float[] luminances = luminances();
        for (int point = 0; point < points; point++) {
            float scale = scale(factors[point] & 0xffff, steps);
            int rgb = LightSamples.CHANNELS * point;
            for (int channel = 0; channel < LightSamples.CHANNELS; channel++) {
                samples.radiance()[rgb + channel] = scale * ((planes[channel][point] & 0xff) / 255f);
            }
            int code = planes[LightSamples.CHANNELS + 3][point] & 0xff;
            float luminance = luminance(samples.radiance(), rgb) * luminances[code];
            int moment = LightSamples.MOMENTS * point;
            samples.moments()[moment + 3] = luminance;
            for (int axis = 0; axis < 3; axis++) {
                samples.moments()[moment + axis] = luminance * planes[LightSamples.CHANNELS + axis][point] / 127f;
            }
        }
        return samples;
    }

    private static int factor(float greatest) {
        if (!(greatest >= Float.MIN_NORMAL)) {
            return 0;
        }
        long code = FACTOR_OF_ONE + Math.round(FACTOR_STEPS * (StrictMath.log(greatest) / StrictMath.log(2)));
        return (int) Math.min(code, 2 * FACTOR_OF_ONE - 1);
    }

    private static float scale(int factor, double[] steps) {
        int octave = Math.floorDiv(factor - FACTOR_OF_ONE, FACTOR_STEPS);
        return factor == 0 ? 0 : (float) Math.scalb(steps[Math.floorMod(factor, FACTOR_STEPS)], octave);
    }

    /** Returns the powers of two from 1 to 2. */
    private static double[] factorSteps() {
        double[] steps = new double[FACTOR_STEPS];
        Arrays.setAll(steps, i -> StrictMath.pow(2, (double) i / FACTOR_STEPS));
        return steps;
    }

    /** Returns the luminance of moments, relative to that of the radiance, of every code. */
    private static float[] luminances() {
        float[] values = new float[256];
        for (int code = 1; code < values.length; code++) {
            values[code] = (float) (LEAST_LUMINANCE * StrictMath.pow(2, (code - 1.0) / LUMINANCE_STEPS));
        }
        return values;
    }

    private static float luminance(float[] rgb, int at) {
        return WEIGHTS[0] * rgb[at] + WEIGHTS[1] * rgb[at + 1] + WEIGHTS[2] * rgb[at + 2];
    }
}
