package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The proof air-fields computes whole fields; here a computation is stopped before it begins. */
class AirTablesTest {
    private static final Air THIN = new Air(Vec3.ZERO, 0.5, 0.7, 1, 0);

    private static final DoubleConsumer STOP = done -> {
        throw new CancellationException("a computation began at " + done);
    };

    private final Map<String, byte[]> kept = new HashMap<>();
    private final AirFiles files = AirFiles.in(kept);

    private void keep(Air air, LightField field) {
        files.store(LightFieldFile.nameFor(air), LightFieldFile.encode(air, field));
    }

    @Test
    void aFieldThatIsKeptIsNotComputed() {
        LightField field = LightFieldFile.clear();
        field.setGroundIrradiance(3, 1, 0.125);
        keep(THIN, field);
        assertTrue(AirTables.isKept(THIN, files));
        float[][] found = AirTables.of(THIN, files, STOP).field().arrays();
        float[][] expected = field.refined().arrays();
        assertArrayEquals(expected[0], found[0]);
        assertArrayEquals(expected[1], found[1]);
    }

    @Test
    void airThatIsNotKeptIsComputed() {
        keep(THIN, LightFieldFile.clear());
        Air hazy = new Air(Vec3.ZERO, 5, 0.7, 1, 0);
        assertFalse(AirTables.isKept(hazy, files));
        assertThrows(CancellationException.class, () -> AirTables.of(hazy, files, STOP));
        assertEquals(1, kept.size(), "nothing of a stopped computation is kept");
    }

    @Test
    void aDamagedFieldIsComputedAgain() {
        keep(THIN, LightFieldFile.clear());
        byte[] damaged = kept.get(LightFieldFile.nameFor(THIN));
        damaged[damaged.length / 2] ^= 1;
        assertThrows(CancellationException.class, () -> AirTables.of(THIN, files, STOP));
    }

    @Test
    void clearAirNeedsNoFile() {
        AirTables.of(Air.CLEAR, files, STOP);
        assertTrue(kept.isEmpty());
    }

    /** What the proof air-fields compares. */
    @Test
    void anotherNumberInTheFieldOfClearAirIsFound() throws IOException {
        byte[] own;
        try (InputStream file = LightFieldFile.class.getResourceAsStream("clear-air.field")) {
            own = file.readAllBytes();
        }
        assertEquals(0, LightFieldFile.differenceFromClear(new ByteArrayInputStream(own)));
        ByteBuffer numbers = ByteBuffer.wrap(new GZIPInputStream(new ByteArrayInputStream(own)).readAllBytes());
        int last = numbers.capacity() - Float.BYTES;
        numbers.putFloat(last, numbers.getFloat(last) + 0.25f);
        ByteArrayOutputStream other = new ByteArrayOutputStream();
        try (GZIPOutputStream compressed = new GZIPOutputStream(other)) {
            compressed.write(numbers.array());
        }
        assertEquals(0.25, LightFieldFile.differenceFromClear(new ByteArrayInputStream(other.toByteArray())), 1e-6);
    }
}
