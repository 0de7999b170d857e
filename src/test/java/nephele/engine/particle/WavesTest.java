package nephele.engine.particle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Chance;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Sines by polynomial, and random numbers by index. */
@Execution(ExecutionMode.CONCURRENT)
class WavesTest {
    @Test
    void sineAndCosineAreThoseOfTheLibrary() {
        for (double turns = -3; turns < 3; turns += 0.00137) {
            assertEquals(Math.sin(2 * Math.PI * turns), Waves.sine(turns), 1e-5);
            assertEquals(Math.cos(2 * Math.PI * turns), Waves.cosine(turns), 1e-5);
        }
        assertEquals(Waves.sine(0.3), Waves.sine(1e7 + 0.3), 1e-7);
    }

    @Test
    void randomNumbersAreEvenAndDifferByPurpose() {
        double sum = 0;
        double product = 0;
        int count = 20_000;
        for (int i = 0; i < count; i++) {
            double a = Chance.unit(Chance.dice(5, i), 1);
            assertTrue(a >= 0 && a < 1);
            sum += a;
            product += Chance.signed(Chance.dice(5, i), 1) * Chance.signed(Chance.dice(5, i), 2);
        }
        assertEquals(0.5, sum / count, 0.01);
        assertEquals(0, product / count, 0.01);
    }
}
