package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Slow motion is noticed below four frames a second, but neither a single long frame nor the first ones. */
class TimeLossTest {
    private static final long MILLISECOND = 1_000_000L;

    @ParameterizedTest
    @CsvSource({"16, 0", "249, 0", "250, 0", "260, 0", "300, 9", "500, 10"})
    void onlyLostTimeIsNoticed(long frameMs, int expected) {
        SlowAdvice slow = new SlowAdvice();
        slow.restart();
        long now = 0;
        long lost = 0;
        int noticed = 0;
        while (now < 22_000 * MILLISECOND) {
            now += frameMs * MILLISECOND;
            lost += Math.max(0, frameMs - 250) * MILLISECOND;
            noticed += slow.isTimeLost(now, lost) ? 1 : 0;
        }
        assertEquals(expected, noticed, 1);
        assertEquals(expected == 0, noticed == 0);
    }

    @ParameterizedTest
    @CsvSource({"0", "50"})
    void oneLongFrameIsNot(int at) {
        SlowAdvice slow = new SlowAdvice();
        long now = 0;
        long lost = 0;
        for (int frame = 0; frame < 200; frame++) {
            long ms = frame == at ? 400 : 30;
            now += ms * MILLISECOND;
            lost += Math.max(0, ms - 250) * MILLISECOND;
            assertEquals(false, slow.isTimeLost(now, lost));
        }
    }
}
