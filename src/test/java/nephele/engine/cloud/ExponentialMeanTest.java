package nephele.engine.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ExponentialMeanTest {
    /** The naive quotient loses all digits at 1e-17 and half of them at 1e-8. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-300, 1e-17, 1e-8, 1e-6, 9.99e-4, 1.01e-3, 0.1, 1, 10})
    void theMeanHasTwelveDigits(double x) {
        assertEquals(exact(x), TwoStreamSlab.exponentialMean(x), 2e-12 * exact(x));
    }

    @Test
    void seriesAndQuotientMeet() {
        double at = TwoStreamSlab.SERIES_BELOW;
        assertEquals(TwoStreamSlab.exponentialMean(Math.nextDown(at)), TwoStreamSlab.exponentialMean(at), 1e-12);
    }

    @Test
    void aDeepLayerHasOneOverItsDepth() {
        assertEquals(1e-4, TwoStreamSlab.exponentialMean(1e4));
        assertEquals(0, TwoStreamSlab.exponentialMean(Double.POSITIVE_INFINITY));
    }

    /** Sums Σ (−x)ⁿ/(n+1)! with 60 digits. */
    private static double exact(double x) {
        var digits = new MathContext(60);
        var term = BigDecimal.ONE;
        var sum = BigDecimal.ONE;
        for (int n = 1; n < 120; n++) {
            term = term.multiply(new BigDecimal(-x), digits).divide(BigDecimal.valueOf(n + 1), digits);
            sum = sum.add(term, digits);
        }
        return sum.doubleValue();
    }
}
