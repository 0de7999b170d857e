package nephele.engine.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import nephele.engine.cloud.light.CloudOptics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Phase functions are normalised and sampled as they are distributed, up to the sharpest peaks. */
class PhaseFunctionTest {
    static Stream<PhaseFunction> phases() {
        return Stream.of(-0.999, -0.5, 0.0, 1e-12, 0.3, 0.85, 0.99, 0.999).map(HenyeyGreenstein::new);
    }

    /** Integrates over separations on steps that grow away from both ends: dω = π d|d − l|². */
    private static double integral(PhaseFunction phase, double from, double to) {
        int steps = 4000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double a = (double) i / steps;
            double b = (i + 1.0) / steps;
            double low = from + (to - from) * graded(a);
            double high = from + (to - from) * graded(b);
            double mid = (low + high) / 2;
            sum += (phase.perSteradian(low) + 4 * phase.perSteradian(mid) + phase.perSteradian(high))
                    * (high - low)
                    / 6;
        }
        return sum * Math.PI;
    }

    private static double graded(double share) {
        return share < 0.5 ? 8 * Math.pow(share, 4) : 1 - 8 * Math.pow(1 - share, 4);
    }

    @ParameterizedTest
    @MethodSource("phases")
    void theIntegralOverTheSphereIsOne(PhaseFunction phase) {
        assertEquals(1, integral(phase, 0, 4), 1e-4);
    }

    /** Forty bins of equal probability; the bound is exceeded once in 100,000 runs. */
    @ParameterizedTest
    @MethodSource("phases")
    void samplesAreDistributedAsTheFunctionSays(PhaseFunction phase) {
        double[] edges = new double[41];
        double g = ((HenyeyGreenstein) phase).g();
        for (int i = 0; i <= 40; i++) {
            edges[i] = new HenyeyGreenstein(g).separationAt(1 - i / 40.0);
        }
        edges[0] = 0;
        edges[40] = 4;
        long[] counts = new long[40];
        var random = new SplittableRandom(5);
        int samples = 100_000;
        for (int n = 0; n < samples; n++) {
            double separation = phase.sampleSeparation(random);
            assertTrue(separation >= 0 && separation <= 4);
            int at = java.util.Arrays.binarySearch(edges, separation);
            counts[Math.min(39, at >= 0 ? at : -at - 2)]++;
        }
        double chiSquared = 0;
        for (int i = 0; i < 40; i++) {
            double expected = samples * integral(phase, edges[i], edges[i + 1]);
            chiSquared += (counts[i] - expected) * (counts[i] - expected) / expected;
        }
        assertTrue(chiSquared < 90, "chi-square of 39 degrees of freedom: " + chiSquared);
    }

    @Test
    void theMeanCosineIsG() {
        var random = new SplittableRandom(6);
        for (double g : new double[] {-0.9, 0, 0.5, 0.85}) {
            double sum = 0;
            for (int n = 0; n < 100_000; n++) {
                sum += 1 - new HenyeyGreenstein(g).sampleSeparation(random) / 2;
            }
            assertEquals(g, sum / 100_000, 4 * Math.sqrt(1 / 3.0 / 100_000));
        }
    }

    @Test
    void twoLobesAreTheirMeanAndAreSampledByTheirShares() {
        var lobes = new CloudOptics(1, 0.9, -0.4, 0.3);
        assertEquals(1, integral(lobes, 0, 4), 1e-4);
        double backwards = integral(lobes, 2, 4);
        var random = new SplittableRandom(7);
        double sum = 0;
        int turned = 0;
        for (int n = 0; n < 100_000; n++) {
            double separation = lobes.sampleSeparation(random);
            sum += 1 - separation / 2;
            turned += separation > 2 ? 1 : 0;
        }
        assertEquals(0.7 * 0.9 - 0.3 * 0.4, sum / 100_000, 4 * Math.sqrt(1 / 3.0 / 100_000));
        assertEquals(backwards, turned / 100_000.0, 4 * Math.sqrt(0.25 / 100_000));
    }

    @Test
    void knownValuesHold() {
        assertEquals(0.0795774715, new HenyeyGreenstein(0).perSteradian(1.3), 1e-10);
        assertEquals(6.543, new HenyeyGreenstein(0.85).perSteradian(0), 5e-4);
        assertEquals(1583.6, new HenyeyGreenstein(0.99).perSteradian(0), 0.05);
        assertEquals(159075, new HenyeyGreenstein(0.999).perSteradian(0), 0.5);
    }

    @Test
    void anAsymmetryBeyondTheLimitIsRefused() {
        for (double g : new double[] {1, -1, 0.9991, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> new HenyeyGreenstein(g));
        }
    }
}
