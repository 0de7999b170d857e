package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * After 10 h, 100 h and a year the phase is exact to 1e-6 rad and the time to 1e-4 s, and tick 0 equals any number of
 * whole periods.
 */
class TickClockTest {
    private static final long PERIOD = TickClock.PERIOD_SECONDS * 120L;

    @ParameterizedTest
    @ValueSource(longs = {0, 1, 12_345, 10 * 3600 * 120L, 100 * 3600 * 120L + 17, 365 * 86_400 * 120L + 5})
    void phasesStayExact(long tick) {
        TickClock clock = new TickClock(120);
        for (int cycles : new int[] {1, 7, 1000, 20_000}) {
            BigInteger turned = BigInteger.valueOf(tick).multiply(BigInteger.valueOf(cycles));
            double share = new BigDecimal(turned.mod(BigInteger.valueOf(PERIOD))).doubleValue() / PERIOD;
            assertEquals(2 * Math.PI * share, clock.phaseRadians(tick, cycles), 1e-6);
        }
        float seconds = clock.secondsInPeriod(tick);
        assertTrue(seconds >= 0 && seconds < 4096);
        assertEquals(tick % PERIOD / 120.0, seconds, 1e-4, "1e-4 rad at one radian a second");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 3, 100_000, 1L << 40})
    void tickZeroEqualsWholePeriods(long periods) {
        TickClock clock = new TickClock(120);
        for (long tick : new long[] {0, 1, 777}) {
            assertEquals(clock.secondsInPeriod(tick), clock.secondsInPeriod(tick + periods * PERIOD));
            assertEquals(clock.phaseRadians(tick, 13), clock.phaseRadians(tick + periods * PERIOD, 13));
        }
    }
}
