package nephele.engine.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class IntervalTest {
    private static Interval median(double... values) {
        return Interval.ofMedian(values, 1_000, 7);
    }

    @Test
    void whatIsAlwaysTheSameIsCertain() {
        var interval = median(3, 3, 3, 3);
        assertEquals(new Interval(3, 3, 3), interval);
    }

    /** A load of up to ten slows both sides of a pair; the ratio of 1.2 is still found. */
    @Test
    void pairingCancelsWhatSlowsBoth() {
        var random = new Random(5);
        double[] base = new double[40];
        double[] tried = new double[40];
        for (int i = 0; i < base.length; i++) {
            double load = 1 + 9 * random.nextDouble();
            base[i] = load;
            tried[i] = 1.2 * load * (1 + 0.01 * random.nextGaussian());
        }
        var interval = Interval.ofRatio(base, tried);
        assertEquals(1.2, interval.estimate(), 0.01);
        assertTrue(interval.low() > 1.19 && interval.high() < 1.21, interval.toString());
    }

    /** A 95 % interval contains the truth in 95 of 100 experiments; the median's is known to be slightly wide. */
    @Test
    void coversTheTruthAsOftenAsItSays() {
        var random = new Random(11);
        int experiments = 400;
        int covered = 0;
        for (int experiment = 0; experiment < experiments; experiment++) {
            double[] values = random.doubles(25).map(u -> -Math.log(1 - u)).toArray();
            Interval interval = median(values);
            covered += interval.low() <= Math.log(2) && Math.log(2) <= interval.high() ? 1 : 0;
        }
        double fraction = (double) covered / experiments;
        assertTrue(fraction > 0.92 && fraction < 0.985, "covered " + fraction);
    }

    @Test
    void theSameNumbersGiveTheSameInterval() {
        double[] values = new Random(3).doubles(20).toArray();
        assertEquals(median(values), median(values));
    }

    @Test
    void refusesWhatHasNoRatio() {
        assertThrows(IllegalArgumentException.class, () -> median(new double[0]));
        assertThrows(IllegalArgumentException.class, () -> Interval.ofRatio(new double[2], new double[2]));
        assertThrows(IllegalArgumentException.class, () -> Interval.ofRatio(new double[2], new double[3]));
    }
}
