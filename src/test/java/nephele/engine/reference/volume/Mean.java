package nephele.engine.reference.volume;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import nephele.engine.measure.RandomMean;

/** A mean of random numbers that tests compare with what is expected. */
record Mean(RandomMean mean) {
    static Mean of(int samples, long seed, ToDoubleFunction<SplittableRandom> sample) {
        return new Mean(RandomMean.of(samples, seed, sample));
    }

    double value() {
        return mean.value();
    }

    double error() {
        return mean.error();
    }

    /** Requires the expected value within four standard errors, and an error of at most a share of it. */
    void requireNear(double expected, double mostRelativeError, String what) {
        String both = what + ": " + value() + " ± " + error() + ", not " + expected;
        assertTrue(Math.abs(value() - expected) <= 4 * error() + 1e-12, both);
        assertTrue(error() <= mostRelativeError * expected, both);
    }
}
