package nephele.lab.trade;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * Times settings in turn. A round runs all of them in a random order and then in the reverse one (A B B A), so that
 * neither a steady drift of the machine nor the order of the runs favours a setting. Other work on the machine affects
 * all settings of a round alike; therefore ratios within rounds are compared, not times.
 */
final class PairedTiming {
    /** The length of each of the two warm-up passes of a setting, in slices; at most {@link #MOST_WARM_UP_NANOS}. */
    private static final double WARM_UP_SLICES = 5;

    private static final double MOST_WARM_UP_NANOS = 0.3e9;

    private final Experiment experiment;
    private final int settings;
    private final double sliceNanos;
    private final CostClock clock;
    private int[] runs;

    /** @param sliceSeconds the least time that a setting runs without interruption */
    PairedTiming(Experiment experiment, int settings, double sliceSeconds, CostClock clock) {
        this.experiment = experiment;
        this.settings = settings;
        this.clock = clock;
        sliceNanos = 1e9 * sliceSeconds;
    }

    /** Lets compilers and caches settle, and determines the number of runs that fill a slice. */
    void warmUp() {
        runs = new int[settings];
        double warm = Math.min(WARM_UP_SLICES * sliceNanos, MOST_WARM_UP_NANOS);
        for (int pass = 0; pass < 2; pass++) {
            for (int setting = 0; setting < settings; setting++) {
                long start = clock.wallNanos();
                int done = 0;
                while (done == 0 || clock.wallNanos() - start < warm) {
                    experiment.run(setting);
                    done++;
                }
                double nanos = (double) (clock.wallNanos() - start) / done;
                runs[setting] = (int) Math.max(1, Math.ceil(sliceNanos / nanos));
            }
        }
    }

    /**
     * Returns the mean costs of the settings in one round.
     *
     * @param number of the round; it determines the order
     */
    List<Cost> round(int number) {
        List<Integer> order =
                new ArrayList<>(IntStream.range(0, settings).boxed().toList());
        Collections.shuffle(order, new Random(number));
        Cost[] there = new Cost[settings];
        for (int setting : order) {
            there[setting] = slice(setting);
        }
        Collections.reverse(order);
        for (int setting : order) {
            there[setting] = there[setting].meanWith(slice(setting));
        }
        return List.of(there);
    }

    /** Times one slice. The first run is not counted, because the caches are filled by another setting. */
    private Cost slice(int setting) {
        experiment.run(setting);
        long bytes = clock.allocatedBytes();
        long cpu = clock.cpuNanos();
        long wall = clock.wallNanos();
        for (int run = 0; run < runs[setting]; run++) {
            experiment.run(setting);
        }
        double each = runs[setting];
        return new Cost(
                Math.max(1, clock.cpuNanos() - cpu) / each,
                Math.max(1, clock.wallNanos() - wall) / each,
                (clock.allocatedBytes() - bytes) / each);
    }
}
