package nephele.engine.cloud.noise;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import nephele.engine.math.Hash64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tables are what a repeated texture is, the same on every machine, and as far away as at the origin. */
class CloudTablesTest {
    private static final CloudTables TABLES = CloudTables.of(7);

    private static List<PeriodicTable> tables() {
        return List.of(TABLES.shape(), TABLES.detail(), TABLES.plan());
    }

    private static EvolvingNoise noise(PeriodicTable table, double generation) {
        return new EvolvingNoise(table, 400, 0.6, 0.8, 3, generation);
    }

    private static long hash(PeriodicTable table) {
        long hash = 0;
        for (short value : table.unorm16()) {
            hash = Hash64.combine(hash, value);
        }
        return hash;
    }

    @Test
    void equalSeedsGiveEqualTablesAndOthersDoNot() {
        CloudTables again = CloudTables.of(7);
        CloudTables other = CloudTables.of(8);
        assertArrayEquals(TABLES.shape().unorm16(), again.shape().unorm16());
        assertArrayEquals(TABLES.detail().unorm16(), again.detail().unorm16());
        assertArrayEquals(TABLES.plan().unorm16(), again.plan().unorm16());
        assertFalse(Arrays.equals(TABLES.shape().unorm16(), other.shape().unorm16()));
        assertFalse(Arrays.equals(TABLES.detail().unorm16(), other.detail().unorm16()));
        assertFalse(Arrays.equals(TABLES.plan().unorm16(), other.plan().unorm16()));
    }

    /** Levels rely on the clouds that a seed gives. */
    @Test
    void theBitsNeverChange() {
        assertEquals(
                List.of("d7e6e8996429bbaa", "76b6c72ba7d7b766", "739187d3a50b1d1c"),
                tables().stream().map(table -> Long.toHexString(hash(table))).toList());
    }

    @Test
    void everyShareOfTheRangeHasAsLargeAShareOfTheValues() {
        for (PeriodicTable table : tables()) {
            int[] counts = new int[16];
            short[] values = table.unorm16();
            for (short value : values) {
                counts[(value & 0xffff) >> 12]++;
            }
            for (int count : counts) {
                assertEquals(values.length / 16.0, count, values.length / 16.0 * 0.03);
            }
        }
    }

    @Test
    void aValueIsAtTheMiddleOfItsTexelAndHalfWayIsTheMean() {
        for (PeriodicTable table : tables()) {
            double n = table.size();
            double layers = table.layers();
            for (int i = -2; i < 2 * n; i += 3) {
                double here = table.value(i, 1, 2) / 65535.0;
                assertEquals(here, table.at((i + 0.5) / n, 1.5 / layers, 2.5 / n), 1e-12);
                double next = table.value(i + 1, 1, 2) / 65535.0;
                assertEquals((here + next) / 2, table.at((i + 1) / n, 1.5 / layers, 2.5 / n), 1e-12);
            }
        }
    }

    @Test
    void aTableContinuesAcrossItsEdge() {
        for (PeriodicTable table : tables()) {
            double inside = 0;
            double across = 0;
            int n = table.size();
            for (int j = 0; j < n; j++) {
                for (int i = 0; i < n; i++) {
                    int step = Math.abs(table.value(i, 0, j) - table.value(i + 1, 0, j));
                    inside = i < n - 1 ? Math.max(inside, step) : inside;
                    across = i == n - 1 ? Math.max(across, step) : across;
                }
            }
            assertTrue(across <= inside && across > 0, across + " of " + inside);
        }
    }

    @Test
    void noPointExceedsTheBoundOfItsBox() {
        var random = new SplittableRandom(1);
        for (PeriodicTable table : tables()) {
            for (double generation : new double[] {0, 0.3, 7.8}) {
                var noise = noise(table, generation);
                for (int n = 0; n < 300; n++) {
                    double x = random.nextDouble(-1e4, 1e4);
                    double y = random.nextDouble(-1e4, 1e4);
                    double z = random.nextDouble(-1e4, 1e4);
                    double half = Math.pow(10, random.nextDouble(-3, 2.5));
                    double bound = noise.greatest(x, y, z, half, half / 3, half / 2);
                    for (int p = 0; p < 20; p++) {
                        double value = noise.at(
                                x + half * random.nextDouble(-1, 1),
                                y + half / 3 * random.nextDouble(-1, 1),
                                z + half / 2 * random.nextDouble(-1, 1));
                        assertTrue(value >= 0 && value <= bound + 1e-12, value + " over " + bound);
                    }
                }
            }
        }
    }

    /** A generation changes the values but neither their mean nor their spread. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.2, 0.5, 0.8, 1, 500.5})
    void evolutionKeepsTheContrast(double generation) {
        var noise = noise(TABLES.plan(), generation);
        var random = new SplittableRandom(2);
        int count = 20_000;
        double sum = 0;
        double squares = 0;
        for (int n = 0; n < count; n++) {
            double value = noise.at(random.nextDouble(1e6), 0, random.nextDouble(1e6));
            sum += value;
            squares += value * value;
        }
        double mean = sum / count;
        assertEquals(0.5, mean, 0.02);
        assertEquals(1 / Math.sqrt(12), Math.sqrt(squares / count - mean * mean), 0.035);
    }

    @Test
    void evolutionIsContinuousAndComesBack() {
        double[] at = {123, 45, 678};
        for (double generation : new double[] {1, 2, EvolvingNoise.GENERATIONS}) {
            double before = value(generation - 1e-9, at);
            assertEquals(before, value(generation, at), 1e-8);
        }
        assertEquals(value(0.25, at), value(EvolvingNoise.GENERATIONS + 0.25, at), 1e-12);
        assertTrue(Math.abs(value(0, at) - value(1, at)) > 1e-3);
    }

    private static double value(double generation, double[] at) {
        return noise(TABLES.shape(), generation).at(at[0], at[1], at[2]);
    }

    /** {@code fract(sin(dot))} has 268 distinct values of 65536 at 1e7; this noise has nearly all at 1e9 metres. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e6, 1e9})
    void farCoordinatesAreAsGoodAsNearOnes(double far) {
        var noise = noise(TABLES.plan(), 0);
        Set<Double> distinct = new HashSet<>();
        int[] counts = new int[16];
        int cells = 256;
        for (int k = 0; k < cells; k++) {
            for (int i = 0; i < cells; i++) {
                double value = noise.at(far + 17.3 * i, 0, far - 23.9 * k);
                distinct.add(value);
                counts[Math.min(15, (int) (16 * value))]++;
            }
        }
        assertTrue(distinct.size() > 0.98 * cells * cells, distinct.size() + " distinct values");
        double expected = cells * cells / 16.0;
        double chi = 0;
        for (int count : counts) {
            chi += (count - expected) * (count - expected) / expected;
        }
        // Neighbours are alike and interpolation narrows the ends; an uneven hash would give some ten thousand.
        assertTrue(chi < 1500, "chi² " + chi);
    }
}
