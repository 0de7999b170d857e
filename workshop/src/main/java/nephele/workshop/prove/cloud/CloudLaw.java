package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.measure.RandomMean;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;

/**
 * A number that theory knows and random walks estimate.
 *
 * @param slack by which the number may be wrong as theory has it for another body; 0 for none
 * @param paths at full count
 */
record CloudLaw(String name, double expected, double slack, long paths, Estimate estimate) {
    static final double MOST_SIGMAS = 4;
    static final double MOST_ERROR = 0.002;

    /** What rounding may add. */
    private static final double ROUNDING = 1e-9;

    /** Estimates the number by random walks. */
    interface Estimate {
        RandomMean of(long paths, long seed);
    }

    /**
     * Compares an estimate.
     *
     * @param mostError greatest standard error
     */
    ProofResult compared(long seed, long count, double mostError) {
        RandomMean found = estimate.of(count, seed);
        double off = Math.max(0, Math.abs(found.value() - expected) - slack - ROUNDING);
        List<String> failures = new ArrayList<>();
        boolean isNear = off <= MOST_SIGMAS * found.error() || isTooRare(found, count);
        if (!isNear || found.error() > mostError) {
            failures.add(String.format(
                    Locale.ROOT, "%s: %.8f ± %.1e, not %.8f", name, found.value(), found.error(), expected));
        }
        double sigmas = off == 0 || isTooRare(found, count) ? 0 : off / found.error();
        return ProofResult.of(
                1,
                failures,
                Figure.greatest("farthest from theory", sigmas, "standard errors"),
                Figure.greatest("greatest standard error", found.error(), ""),
                Figure.sum("paths", count, ""));
    }

    /**
     * Returns true if no path brought light, and so few do that this is no wonder: a path brings at most 1, and the root
     * of the number of those that bring as much is their deviation.
     */
    private boolean isTooRare(RandomMean found, long count) {
        return found.value() == 0 && found.error() == 0 && expected * count < MOST_SIGMAS;
    }
}
