package nephele.lab.trade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Costs are right on a clock that only the runs themselves advance. */
class PairedTimingTest {
    private static final int SETTINGS = 3;
    private static final long CPU_NANOS = 1_000;
    private static final double SLICE_SECONDS = 40e-6;

    /** Setting s takes s + 1 times as long as the first, more after another setting, and more from run to run. */
    private static final class Machine implements Experiment, CostClock {
        private final long afterAnother;
        private final double drift;
        final List<Integer> ran = new ArrayList<>();
        private double cpu;
        private double wall;
        private double bytes;

        Machine(long afterAnother, double drift) {
            this.afterAnother = afterAnother;
            this.drift = drift;
        }

        @Override
        public Judgement judge(int setting) {
            throw new UnsupportedOperationException("nothing is judged here");
        }

        @Override
        public void run(int setting) {
            boolean isFirst = ran.isEmpty() || ran.get(ran.size() - 1) != setting;
            double nanos = CPU_NANOS * (setting + 1) + (isFirst ? afterAnother : 0) + drift * ran.size();
            cpu += nanos;
            wall += 2 * nanos;
            bytes += 16 * (setting + 1) + (isFirst ? afterAnother : 0);
            ran.add(setting);
        }

        @Override
        public void close() {}

        @Override
        public long cpuNanos() {
            return Math.round(cpu);
        }

        @Override
        public long wallNanos() {
            return Math.round(wall);
        }

        @Override
        public long allocatedBytes() {
            return Math.round(bytes);
        }

        PairedTiming timing() {
            var timing = new PairedTiming(this, SETTINGS, SLICE_SECONDS, this);
            timing.warmUp();
            ran.clear();
            return timing;
        }
    }

    @Test
    void aCostIsTheMeanOfARunWithoutTheFirstAfterAnother() {
        PairedTiming timing = new Machine(70_000, 0).timing();
        for (int round = 0; round < 20; round++) {
            List<Cost> costs = timing.round(round);
            assertEquals(SETTINGS, costs.size());
            for (int setting = 0; setting < SETTINGS; setting++) {
                double expected = CPU_NANOS * (setting + 1);
                assertEquals(new Cost(expected, 2 * expected, 16 * (setting + 1)), costs.get(setting));
            }
        }
    }

    /** The slices of a round have one order and then the reverse, so that a steady drift affects all settings alike. */
    @Test
    void aSteadyDriftFavoursNoSetting() {
        var machine = new Machine(0, 10);
        PairedTiming timing = machine.timing();
        List<Cost> costs = timing.round(5);
        int half = machine.ran.size() / 2;
        for (int i = 0; i < half; i++) {
            assertEquals(machine.ran.get(i), machine.ran.get(machine.ran.size() - 1 - i), "run " + i);
        }
        double middle = 10 * (machine.ran.size() - 1) / 2.0;
        for (int setting = 0; setting < SETTINGS; setting++) {
            // The first run of each slice does not count: on average the others come half a run later.
            assertEquals(
                    CPU_NANOS * (setting + 1) + middle + 5, costs.get(setting).cpuNanos(), 1, "setting " + setting);
        }
    }

    /** A slice has as many runs as fill it, whatever a run takes; another round has another order. */
    @Test
    void aSliceIsAsLongForEverySetting() {
        var machine = new Machine(0, 0);
        PairedTiming timing = machine.timing();
        timing.round(1);
        List<Integer> first = new ArrayList<>(machine.ran);
        for (int setting = 0; setting < SETTINGS; setting++) {
            int wanted = setting;
            long runs = first.stream().filter(ran -> ran == wanted).count();
            // Two slices of 40 µs of wall time, each with one more run that does not count.
            assertEquals(2 * (Math.ceil(20.0 / (setting + 1)) + 1), runs, "setting " + setting);
        }
        machine.ran.clear();
        timing.round(2);
        assertEquals(first.size(), machine.ran.size());
        assertNotEquals(first, machine.ran);
    }
}
