package nephele.engine.measure;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * Which of several choices are worth having, as far as the measurement can tell. A choice is dominated by another one that is
 * cheaper beyond doubt and errs no more, or that seems to cost no more and errs less.
 */
public final class ParetoFront {
    private final List<Choice> choices;
    private final double errorStep;
    private final double costStep;

    /** Smaller is better in both. */
    public record Choice(Interval cost, double error) {
        public Choice {
            if (!Double.isFinite(cost.low() + cost.estimate() + cost.high()) || !Double.isFinite(error)) {
                throw new IllegalArgumentException(
                        "a choice needs a finite cost and error, not " + cost + ", " + error);
            }
        }

        /** Of a cost that was counted. */
        public static Choice exact(double cost, double error) {
            return new Choice(new Interval(cost, cost, cost), error);
        }
    }

    /**
     * @param errorStep errors that differ by no more than this count as equal
     * @param costStep so do costs whose intervals are apart by no more than this share
     */
    public ParetoFront(List<Choice> choices, double errorStep, double costStep) {
        this.choices = List.copyOf(choices);
        this.errorStep = errorStep;
        this.costStep = costStep;
    }

    public boolean holds(int index) {
        return dominating(index).isEmpty();
    }

    /** The most accurate choice on the front that dominates this one, and of equal ones the cheapest; empty on the front. */
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
