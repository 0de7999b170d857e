package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Seeded noise is bounded, repeatable and finite for every float; the shader's twin has its own test. */
@Execution(ExecutionMode.CONCURRENT)
class SeededNoiseTest {
    private final SeededNoise noise = new SeededNoise(42);

    @Test
    void valuesLieInTheHalfOpenUnitInterval() {
        var random = new SplittableRandom(36);
        for (int i = 0; i < 100_000; i++) {
            double x = i % 4 == 0 ? Double.longBitsToDouble(random.nextLong()) : random.nextDouble(-1e10, 1e10);
            double value = noise.at(x, random.nextDouble(-3, 3), -1e-20);
            assertTrue(value >= 0 && value < 1, x + " gives " + value);
        }
    }

    /** Just below a whole number the difference to the floor rounds to 1; the fraction stays below 1. */
    @Test
    void aFractionNeverReachesOne() {
        double last = Math.nextDown(1.0);
        for (double below : new double[] {-1e-20, -0x1p-54, -Double.MIN_VALUE}) {
            assertEquals(last, SeededNoise.fraction(below));
        }
        assertEquals(last, SeededNoise.fraction(-0x1p-53));
        assertEquals(0, SeededNoise.fraction(-3));
        assertEquals(0.25, SeededNoise.fraction(-0.75));
        var random = new SplittableRandom(37);
        for (int i = 0; i < 100_000; i++) {
            double x = Double.longBitsToDouble(random.nextLong());
            double fraction = SeededNoise.fraction(Double.isFinite(x) ? x : i);
            assertTrue(fraction >= 0 && fraction < 1, x + " gives " + fraction);
        }
    }

    @Test
    void valuesAreSpreadEvenly() {
        int[] histogram = new int[16];
        for (int x = -50; x < 50; x++) {
            for (int y = -50; y < 50; y++) {
                for (int z = -8; z < 8; z++) {
                    histogram[(int) (16 * noise.unit(x, y, z))]++;
                }
            }
        }
        for (int count : histogram) {
            assertEquals(10_000, count, 500);
        }
    }

    /** In 256 × 256 cells far away: as many values as 24 random bits have, evenly spread, neighbours unlike. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e6, 1e9, -1e9})
    void farCellsAreAsGoodAsNearOnes(double far) {
        int side = 256;
        Set<Double> distinct = new HashSet<>();
        int[] histogram = new int[256];
        double products = 0;
        double before = 0.5;
        for (int i = 0; i < side * side; i++) {
            double value = noise.unit(SeededNoise.cell(far + i % side), SeededNoise.cell(far - i / side), 3);
            distinct.add(value);
            histogram[(int) (256 * value)]++;
            products += (value - 0.5) * (before - 0.5);
            before = value;
        }
        double chi = 0;
        for (int count : histogram) {
            chi += (count - 256.0) * (count - 256.0) / 256;
        }
        assertTrue(distinct.size() > 65_300, distinct.size() + " distinct values");
        assertEquals(255, chi, 5 * Math.sqrt(2 * 255), "chi² of 255 degrees of freedom");
        assertEquals(0, 12 * products / (side * side), 0.02, "correlation of neighbours");
    }

    @Test
    void noiseIsContinuousAcrossCellsAndNotPeriodicWithinTwoToTheThirtyOne() {
        for (int cell = -3; cell <= 3; cell++) {
            assertEquals(noise.at(cell, 0.5, 0.5), noise.at(Math.nextDown((double) cell), 0.5, 0.5), 1e-9);
        }
        double atZero = noise.at(0, 0, 0);
        assertNotEquals(atZero, noise.at(0x1p31, 0, 0));
        assertNotEquals(atZero, noise.at(0x1p30, 0, 0));
        assertEquals(atZero, noise.at(0x1p32, 0, 0));
        assertEquals(SeededNoise.cell(-0x1p31), SeededNoise.cell(0x1p31));
    }

    @Test
    void theBitsNeverChange() {
        assertEquals(new SeededNoise(7).bits(1, 2, 3), new SeededNoise(7).bits(1, 2, 3));
        assertNotEquals(new SeededNoise(7).bits(1, 2, 3), new SeededNoise(8).bits(1, 2, 3));
        assertEquals(pcg3d(1, 2, 3), new SeededNoise(0).bits(1, 2, 3));
    }

    /** Returns the published hash, with unsigned arithmetic written in long. */
    private static int pcg3d(long x, long y, long z) {
        long mask = 0xFFFFFFFFL;
        long[] v = {x * 1664525 + 1013904223 & mask, y * 1664525 + 1013904223 & mask, z * 1664525 + 1013904223 & mask};
        v[0] = v[0] + v[1] * v[2] & mask;
        v[1] = v[1] + v[2] * v[0] & mask;
        v[2] = v[2] + v[0] * v[1] & mask;
        for (int i = 0; i < 3; i++) {
            v[i] ^= v[i] >>> 16;
        }
        return (int) (v[0] + v[1] * v[2] & mask);
    }
}
