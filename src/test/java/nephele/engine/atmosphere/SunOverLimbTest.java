package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SunOverLimbTest {
    private static final double RADIUS = SunOverLimb.RADIUS_RADIANS;
    private static final int STRIPS = 20_000;

    private static double sine(double radii, double heightMetres) {
        return Math.sin(SkyTable.horizonRadians(heightMetres) + radii * RADIUS);
    }

    /** Sums over thin strips of the disc, those below the horizon left out. */
    private static double exact(double middleRadii, DoubleUnaryOperator ofRadiiAboveMiddle) {
        double sum = 0;
        for (int i = 0; i < STRIPS; i++) {
            double x = 2 * (i + 0.5) / STRIPS - 1;
            sum += middleRadii + x < 0
                    ? 0
                    : ofRadiiAboveMiddle.applyAsDouble(x) * 2 * Math.sqrt(1 - x * x) / Math.PI * 2 / STRIPS;
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({"-0.95, 0", "-0.5, 0", "0, 0", "0, 12000", "0.3, 2", "0.9, 80000", "1, 0", "7, 2"})
    void meansOfQuadraticFunctionsOverTheVisiblePartAreExact(double radii, double height) {
        double middle = sine(radii, height);
        SunOverLimb disc = SunOverLimb.of(height, middle);
        assertEquals(exact(radii, x -> 1), disc.fraction(), 1e-5, "the visible fraction");
        DoubleUnaryOperator light = x -> 2 + 0.7 * x + 0.4 * x * x;
        double perRadius = Math.sqrt(1 - middle * middle) * RADIUS;
        double low = light.applyAsDouble((disc.lowSine() - middle) / perRadius);
        double high = light.applyAsDouble((disc.highSine() - middle) / perRadius);
        assertEquals(exact(radii, light), disc.fraction() * (low + high) / 2, 1e-4);
    }

    @Test
    void nothingOfItIsSeenBelowTheHorizonAndAllOfItHighUp() {
        assertEquals(0, SunOverLimb.of(3000, sine(-1.001, 3000)).fraction());
        assertEquals(0, SunOverLimb.of(0, -1).fraction());
        assertEquals(new SunOverLimb(1, 1, 1), SunOverLimb.of(0, 1));
    }

    @Test
    void theShareGrowsWithoutAStep() {
        double before = 0;
        for (int i = -120; i <= 120; i++) {
            SunOverLimb disc = SunOverLimb.of(500, sine(i / 100.0, 500));
            assertTrue(
                    disc.fraction() >= before && disc.fraction() - before < 0.0065,
                    "at " + i + " hundredths of a radius");
            assertTrue(disc.lowSine() <= disc.highSine());
            before = disc.fraction();
        }
        assertEquals(1, before);
    }

    @Test
    void aPointIsSeenWhollyOrNotAtAll() {
        assertEquals(1, SunOverLimb.of(0, 40, sine(1e-6, 40)).fraction());
        assertEquals(0, SunOverLimb.of(0, 40, sine(-1e-6, 40)).fraction());
    }
}
