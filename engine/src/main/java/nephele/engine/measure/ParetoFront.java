package nephele.engine.measure;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * The Pareto-optimal ones of several choices, within the accuracy of the measurement. A choice is dominated by another
 * that is significantly cheaper and has no greater error, or that has no greater estimated cost and a smaller error.
 */
public final class ParetoFront {
    private final List<Choice> choices;
    private final double errorStep;
    private final double costStep;

    /** A choice with its cost and error; smaller is better in both. */
    public record Choice(Interval cost, double error) {
        public Choice {
            if (!Double.isFinite(cost.low() + cost.estimate() + cost.high()) || !Double.isFinite(error)) {
                throw new IllegalArgumentException(
                        "a choice needs a finite cost and error, not " + cost + ", " + error);
            }
        }
    }

    /**
     * Creates the front of some choices.
     *
     * @param errorStep errors that differ by no more than this count as equal
     * @param costStep costs with intervals that are apart by no more than this fraction count as equal
     */
    public ParetoFront(List<Choice> choices, double errorStep, double costStep) {
        this.choices = List.copyOf(choices);
        this.errorStep = errorStep;
        this.costStep = costStep;
    }

    /**
     * Returns the dominating choice of least error, and of equal ones the cheapest; empty for a choice on the front.
     */
    public OptionalInt dominating(int index) {
        return IntStream.range(0, choices.size())
                .filter(other -> dominates(choices.get(other), choices.get(index)))
                .reduce((a, b) -> isBetter(choices.get(b), choices.get(a)) ? b : a);
    }

    private boolean dominates(Choice a, Choice b) {
        boolean surelyCheaper = a.cost.high() < b.cost.low() * (1 - costStep);
        boolean seemsNoDearer = a.cost.estimate() <= b.cost.estimate();
        return surelyCheaper && a.error <= b.error + errorStep || seemsNoDearer && a.error < b.error - errorStep;
    }

    private static boolean isBetter(Choice a, Choice b) {
        return a.error < b.error || a.error == b.error && a.cost.estimate() < b.cost.estimate();
    }
}
