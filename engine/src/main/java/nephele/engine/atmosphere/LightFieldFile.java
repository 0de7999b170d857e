package nephele.engine.atmosphere;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** The light field of clear air as a file of the program: compressed floats, in the order of {@link LightField}. */
public final class LightFieldFile {
    private static final String CLEAR = "clear-air.field";

    private LightFieldFile() {}

    static LightField clear() {
        try (InputStream stream = LightFieldFile.class.getResourceAsStream(CLEAR)) {
            LightField field = new LightField(ScatteringOrders.FIRST_DEGREE);
            DataInputStream numbers = new DataInputStream(new GZIPInputStream(stream, 1 << 16));
            for (float[] values : field.arrays()) {
                for (int i = 0; i < values.length; i++) {
                    values[i] = numbers.readFloat();
                }
            }
            return field;
        } catch (IOException damaged) {
            throw new UncheckedIOException(CLEAR, damaged);
        }
    }

    /** Writes the field of clear air, computed anew. */
    public static void write(OutputStream out) throws IOException {
        LightField field = ScatteringOrders.sum(Air.CLEAR, new SunTransmittance(Air.CLEAR));
        try (DataOutputStream numbers = new DataOutputStream(new GZIPOutputStream(out))) {
            for (float[] values : field.arrays()) {
                for (float value : values) {
                    numbers.writeFloat(value);
                }
            }
        }
    }
}
