package nephele.engine.atmosphere;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import nephele.engine.atmosphere.ScatteringOrders.Accuracy;
import nephele.engine.math.Vec3;

/**
 * A light field as a compressed file of floats, in the order of {@link LightField}. That of clear air is a file of the
 * program; files of other air begin with the numbers of that air.
 */
public final class LightFieldFile {
    /** The glob of the names that {@link #nameFor} returns. */
    public static final String NAMES = "air-*.field";

    /** Part of every name: raise it whenever the same air would have another field. */
    private static final int VERSION = 2;

    private static final String CLEAR = "clear-air.field";

    private LightFieldFile() {}

    /** Returns the file name, a hash of the air's numbers. */
    static String nameFor(Air air) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(header(air));
            return "air-" + HexFormat.of().formatHex(hash, 0, 16) + ".field";
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static byte[] header(Air air) {
        Vec3 albedo = air.groundAlbedo();
        double[] numbers = {VERSION, albedo.x(), albedo.y(), albedo.z(), air.mieScale(), air.mieG(), air.ozoneScale()};
        ByteBuffer bytes = ByteBuffer.allocate(numbers.length * Double.BYTES);
        Arrays.stream(numbers).forEach(bytes::putDouble);
        return bytes.array();
    }

    static byte[] encode(Air air, LightField field) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(new GZIPOutputStream(bytes))) {
            out.write(header(air));
            write(field, out);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    /** Returns the field of a file; empty if the file is damaged, or of other air. */
    static Optional<LightField> decode(Air air, byte[] file) {
        byte[] header = header(air);
        try (DataInputStream in = compressed(new ByteArrayInputStream(file))) {
            if (!Arrays.equals(header, in.readNBytes(header.length))) {
                return Optional.empty();
            }
            LightField field = read(in);
            // Reading the end checks the checksum of the whole.
            return in.read() == -1 ? Optional.of(field) : Optional.empty();
        } catch (IOException damaged) {
            return Optional.empty();
        }
    }

    static LightField clear() {
        try (InputStream stream = LightFieldFile.class.getResourceAsStream(CLEAR)) {
            return read(compressed(stream));
        } catch (IOException damaged) {
            throw new UncheckedIOException(CLEAR, damaged);
        }
    }

    /** Writes the field of clear air, computed anew: the file of the program. */
    public static void write(OutputStream out) throws IOException {
        write(out, Accuracy.FINE);
    }

    /** Writes the field of clear air, computed as quickly as that of other air. */
    public static void writeQuick(OutputStream out) throws IOException {
        write(out, Accuracy.QUICK);
    }

    private static void write(OutputStream out, Accuracy accuracy) throws IOException {
        LightField field = ScatteringOrders.sum(Air.CLEAR, new SunTransmittance(Air.CLEAR), accuracy, done -> {});
        try (DataOutputStream numbers = new DataOutputStream(new GZIPOutputStream(out))) {
            write(field, numbers);
        }
    }

    /** Returns the greatest difference between the numbers of the program's field of clear air and those of another file. */
    public static double differenceFromClear(InputStream file) throws IOException {
        return differenceFromClear(file, Double.NEGATIVE_INFINITY);
    }

    /** Does the same for the nodes that are not darker. @param darkest natural logarithm of the light in the program's field */
    public static double differenceFromClear(InputStream file, double darkest) throws IOException {
        float[][] own = clear().arrays();
        float[][] other = read(compressed(file)).arrays();
        int[] perNode = {DirectionMoments.count(ScatteringOrders.FIRST_DEGREE), 1};
        double greatest = 0;
        for (int array = 0; array < own.length; array++) {
            for (int i = 0; i < own[array].length; i++) {
                double difference = Math.abs(own[array][i] - other[array][i]);
                boolean isDark = own[array][i - i % perNode[array]] < darkest;
                greatest = isDark || difference <= greatest ? greatest : difference;
            }
        }
        return greatest;
    }

    private static DataInputStream compressed(InputStream file) throws IOException {
        return new DataInputStream(new GZIPInputStream(file, 1 << 16));
    }

    private static LightField read(DataInputStream numbers) throws IOException {
        LightField field = new LightField(ScatteringOrders.FIRST_DEGREE);
        for (float[] values : field.arrays()) {
            for (int i = 0; i < values.length; i++) {
                values[i] = numbers.readFloat();
            }
        }
        return field;
    }

    private static void write(LightField field, DataOutputStream numbers) throws IOException {
        for (float[] values : field.arrays()) {
            for (float value : values) {
                numbers.writeFloat(value);
            }
        }
    }
}
