package nephele.engine.measure;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;

/** The mean of random numbers and its standard error. */
public record RandomMean(double value, double error) {
    /** @param sample returns one number, from the given source of random numbers */
    public static RandomMean of(long samples, long seed, ToDoubleFunction<SplittableRandom> sample) {
        var random = new SplittableRandom(seed);
        double sum = 0;
        double squares = 0;
        for (long n = 0; n < samples; n++) {
            double value = sample.applyAsDouble(random);
            sum += value;
            squares += value * value;
        }
        double mean = sum / samples;
        return new RandomMean(mean, Math.sqrt(Math.max(0, squares / samples - mean * mean) / samples));
    }

    /** Returns this less another, independent mean. */
    public RandomMean minus(RandomMean other) {
        return new RandomMean(value - other.value, Math.hypot(error, other.error));
    }

    /** Returns the mean of the numbers times a factor. */
    public RandomMean scaled(double factor) {
        return new RandomMean(value * factor, error * Math.abs(factor));
    }
}
