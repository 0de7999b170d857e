package nephele.engine.level.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The text is the shortest that reads back, on every machine. */
@Execution(ExecutionMode.CONCURRENT)
class NumberTextTest {
    private static final int PATTERNS = 1_000_000;

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, -0",
        "1, 1",
        "-40, -40",
        "0.1, 0.1",
        "0.05, 0.05",
        "100, 100",
        "1e21, 1e+21",
        "1e20, 100000000000000000000",
        "1e-6, 0.000001",
        "1e-7, 1e-7",
        "1.5e-9, 1.5e-9",
        "4.9e-324, 5e-324",
        "1.7976931348623157e308, 1.7976931348623157e+308",
        "2e23, 2e+23",
        "9007199254740993, 9007199254740992",
        "0.30000000000000004, 0.30000000000000004",
        "123456.789, 123456.789",
        "2.2250738585072014E-308, 2.2250738585072014e-308",
        "4.35, 4.35",
        "1e6, 1000000"
    })
    void knownNumbers(double value, String text) {
        assertEquals(text, NumberText.of(value));
    }

    @Test
    void whatJsonCannotHoldIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> NumberText.of(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> NumberText.of(Double.NEGATIVE_INFINITY));
    }

    /**
     * Random bit patterns and numbers with few decimals read back; the checksum of all texts is that of every Java
     * version.
     */
    @Test
    void aMillionPatternsReadBackBitEqual() {
        SplittableRandom random = new SplittableRandom(48);
        CRC32 sum = new CRC32();
        for (int i = 0; i < PATTERNS; i++) {
            double value = i % 8 == 0 ? anyBits(random) : written(random);
            String text = NumberText.of(value);
            if (Double.doubleToRawLongBits(Double.parseDouble(text)) != Double.doubleToRawLongBits(value)) {
                throw new AssertionError(value + " became " + text);
            }
            sum.update(text.getBytes(StandardCharsets.US_ASCII));
        }
        assertEquals(2_071_682_428L, sum.getValue());
    }

    /** One digit fewer does not read back, rounded down or up. */
    @Test
    void noTextIsLongerThanItMustBe() {
        SplittableRandom random = new SplittableRandom(49);
        for (int i = 0; i < 20_000; i++) {
            double value = Math.abs(i % 2 == 0 ? anyBits(random) : written(random));
            BigDecimal text = new BigDecimal(NumberText.of(value)).stripTrailingZeros();
            if (text.precision() > 1) {
                for (RoundingMode mode : new RoundingMode[] {RoundingMode.DOWN, RoundingMode.UP}) {
                    BigDecimal shorter = new BigDecimal(value).round(new MathContext(text.precision() - 1, mode));
                    assertFalse(Double.parseDouble(shorter.toString()) == value, () -> value + " could be shorter");
                }
            }
        }
    }

    private static double anyBits(SplittableRandom random) {
        double value = Double.longBitsToDouble(random.nextLong());
        return Double.isFinite(value) ? value : random.nextDouble();
    }

    private static double written(SplittableRandom random) {
        double decimals = Double.parseDouble("1e" + random.nextInt(7));
        return random.nextInt(-10_000_000, 10_000_000) / decimals;
    }
}
