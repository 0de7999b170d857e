package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The proof air-fields computes whole fields; here a computation is stopped before it begins. */
class AirTablesTest {
    private static final Air THIN = new Air(Vec3.ZERO, 0.5, 0.7, 1, 0);

    private static final DoubleConsumer STOP = done -> {
        throw new CancellationException("a computation began at " + done);
    };

    private final Map<String, byte[]> kept = new HashMap<>();
    private final AirFiles files = new AirFiles() {
        @Override
        public Optional<byte[]> find(String name) {
            return Optional.ofNullable(kept.get(name));
        }

        @Override
        public void store(String name, byte[] bytes) {
            kept.put(name, bytes);
        }
    };

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
}
