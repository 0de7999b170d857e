package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainDecimalTest {
    private static float read(String text) {
        byte[] bytes = (" " + text + ";").getBytes(StandardCharsets.UTF_8);
        return PlainDecimal.read(bytes, 1, bytes.length - 1);
    }

    private static void assertSame(String text) {
        assertEquals(Float.floatToRawIntBits(Float.parseFloat(text)), Float.floatToRawIntBits(read(text)), () -> text);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"0", "-0", "+5", "5.", ".5", "-.5", "0.1", "16777217", "123456789012345", "0.00000000000001"})
    void itReadsWhatJavaReads(String text) {
        assertSame(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", ".", "+.", "1e5", "1.2.3", "--1", "1-", "NaN", "0x1", "1,5", "1234567890123456"})
    void theRestIsLeftToOthers(String text) {
        assertTrue(Float.isNaN(read(text)), text);
    }

    @Test
    void randomDecimalsAreTheNearestFloats() {
        var random = new SplittableRandom(11);
        int left = 0;
        for (int i = 0; i < 200_000; i++) {
            long digits = random.nextLong(1L << random.nextInt(1, 49));
            String text = BigDecimal.valueOf(random.nextBoolean() ? digits : -digits, random.nextInt(15))
                    .toPlainString();
            if (Float.isNaN(read(text))) {
                left++;
            } else {
                assertSame(text);
            }
        }
        assertTrue(left < 2_000, left + " were left to others");
    }

    /**
     * Rounding to a double first and then to a float gives the wrong result for some of these; the parser never does.
     */
    @Test
    void betweenTwoFloatsNothingIsRoundedTwice() {
        int wrongIfTwice = 0;
        float below = 1.5f;
        for (int i = 0; i < 1_000; i++, below = Math.nextUp(below)) {
            double middle = ((double) below + Math.nextUp(below)) / 2;
            String text = new BigDecimal(middle).round(new MathContext(15)).toPlainString();
            wrongIfTwice += (float) Double.parseDouble(text) == Float.parseFloat(text) ? 0 : 1;
            assertTrue(Float.isNaN(read(text)) || read(text) == Float.parseFloat(text), text);
        }
        assertTrue(wrongIfTwice > 10, wrongIfTwice + " such decimals");
    }
}
