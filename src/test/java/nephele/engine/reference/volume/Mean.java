package nephele.engine.reference.volume;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;

/** The mean of random numbers and its standard error. */
record Mean(double value, double error) {
    static Mean of(int samples, long seed, ToDoubleFunction<SplittableRandom> sample) {
        var random = new SplittableRandom(seed);
        double sum = 0;
        double squared = 0;
        for (int n = 0; n < samples; n++) {
            double value = sample.applyAsDouble(random);
            sum += value;
            squared += value * value;
        }
        double mean = sum / samples;
        return new Mean(mean, Math.sqrt(Math.max(0, squared / samples - mean * mean) / samples));
    }

    /** Requires the expected value within four standard errors, and an error of at most a share of it. */
    void requireNear(double expected, double mostRelativeError, String what) {
        String both = what + ": " + value + " ± " + error + ", not " + expected;
        assertTrue(Math.abs(value - expected) <= 4 * error + 1e-12, both);
        assertTrue(error <= mostRelativeError * expected, both);
    }
}
